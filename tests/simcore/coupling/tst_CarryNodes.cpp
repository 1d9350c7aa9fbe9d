// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/coupling/CarryNodes.h"

#include <gtest/gtest.h>

#include "tests/scenes/NodeScenes.h"

namespace glenoid {
namespace {

const Vec3 kLow(-0.02, 0, 0), kHigh(0.02, 0.02, 0.02);

/// Figure 4's soft part with other cells, n along each edge.
Result<CarriedNodes> carriedTo(Joint& joint, int n, const Vec3& shift = Vec3::Zero()) {
  Part& middle = joint.parts[1];
  const auto before = middle.volume;
  const double cell = middle.cellSize;
  middle.volume = std::make_shared<TetMesh>(scenes::boxVolume(kLow + shift, kHigh + shift, n, n, n));
  middle.cellSize = 0.04 / n;
  return carryNodes(joint, "middle", *before, cell);
}

TEST(CarryNodes, eachNodeBecomesTheNearestOne) {
  Joint joint = scenes::figure4AtNodes();
  const Joint before = joint;
  const auto carried = carriedTo(joint, 4);
  ASSERT_TRUE(carried.ok());
  EXPECT_EQ(carried->couplings, 2);
  EXPECT_EQ(carried->picked, 18);
  EXPECT_EQ(carried->now, 18);
  EXPECT_NEAR(carried->farthest, 0, 1e-15) << "every second node of the finer cells is an old one";
  for (std::size_t c = 0; c < 2; ++c) {
    EXPECT_EQ(joint.couplings[c].stiffnessPerNode, before.couplings[c].stiffnessPerNode);
    for (const int node : joint.couplings[c].nodesA) {
      double nearest = 1;
      for (const int old : before.couplings[c].nodesA) nearest = std::min(nearest, (joint.parts[1].volume->nodes[node] - before.parts[1].volume->nodes[old]).norm());
      EXPECT_LT(nearest, 1e-15);
    }
  }
}

TEST(CarryNodes, whereTwoBecomeOneTheSpringsKeepTheirSum) {
  Joint joint = scenes::figure4AtNodes();
  const auto carried = carriedTo(joint, 1);  // of nine nodes of a face the four corners are left
  ASSERT_TRUE(carried.ok());
  EXPECT_EQ(carried->now, 8);
  EXPECT_NEAR(carried->farthest, std::hypot(0.01, 0.01), 1e-12) << "the middle of a face";
  for (const Coupling& coupling : joint.couplings) {
    EXPECT_EQ(coupling.nodesA.size(), 4u);
    EXPECT_NEAR(4 * coupling.stiffnessPerNode, 4e4, 1e-9);
  }
}

TEST(CarryNodes, theSameCellsChangeNothing) {
  Joint joint = scenes::figure4AtNodes();
  const std::vector<Coupling> before = joint.couplings;
  std::reverse(joint.couplings[0].nodesA.begin(), joint.couplings[0].nodesA.end());
  const auto order = joint.couplings[0].nodesA;
  const auto carried = carriedTo(joint, 2);
  ASSERT_TRUE(carried.ok());
  EXPECT_EQ(carried->couplings, 0);
  EXPECT_EQ(joint.couplings[0].nodesA, order);
}

TEST(CarryNodes, whatFindsNoNodeNearIsRefusedAndNothingChanged) {
  // Half the diagonal of a cell of 20 mm is 17.3 mm.
  Joint joint = scenes::figure4AtNodes();
  EXPECT_TRUE(carriedTo(joint, 2, Vec3(-0.0172, 0, 0)).ok());
  joint = scenes::figure4AtNodes();
  const std::vector<Coupling> before = joint.couplings;
  // Along −x the nodes of the right end lose theirs; those of the left end, 20 mm further, have found others.
  const auto far = carriedTo(joint, 2, Vec3(-0.0174, 0, 0));
  ASSERT_FALSE(far.ok());
  EXPECT_EQ(far.error().fault, Fault::BadNodes);
  EXPECT_EQ(far.error().place.part, "c23");
  EXPECT_EQ(far.error().arguments, (Arguments{"far", "9", "17.4"}));
  EXPECT_EQ(joint.couplings, before);
  joint = scenes::figure4AtNodes();
  joint.parts[1].kind = PartKind::Rigid;
  const auto volume = joint.parts[1].volume;
  joint.parts[1].volume = nullptr;
  EXPECT_EQ(carryNodes(joint, "middle", *volume, 0.02).error().arguments, (Arguments{"rigid", "middle"}));
}

TEST(CarryNodes, whatIsLeftMustHold) {
  Joint joint = scenes::figure4AtNodes();
  const Part& middle = joint.parts[1];
  // Four nodes around one corner: they all become that corner.
  joint.couplings = {scenes::atNodes("c", "middle", "left", scenes::nodesWhere(middle, [](const Vec3& p) {
                                       return p.x() < -0.019 && p.y() < 0.0101 && p.z() < 0.0101;
                                     }), 1e3)};
  ASSERT_EQ(joint.couplings[0].nodesA.size(), 4u);
  joint.parts[1].cellSize = 0.04;
  Joint small = joint;
  TetMesh one = scenes::boxVolume(kLow, kHigh, 1, 1, 1);
  one.nodes[2] += Vec3(0, 0.5, 0), one.nodes[4] += Vec3(0, 0, 0.5), one.nodes[6] += Vec3(0, 0.5, 0.5);  // the corner alone stays near
  one.nodes[1] += Vec3(0.5, 0, 0), one.nodes[3] += Vec3(0.5, 0.5, 0), one.nodes[5] += Vec3(0.5, 0, 0.5), one.nodes[7] += Vec3(0.5, 0.5, 0.5);
  const auto before = small.parts[1].volume;
  small.parts[1].volume = std::make_shared<TetMesh>(one);
  EXPECT_EQ(carryNodes(small, "middle", *before, 0.04).error().arguments, (Arguments{"few", "1"}));
}

}  // namespace
}  // namespace glenoid
