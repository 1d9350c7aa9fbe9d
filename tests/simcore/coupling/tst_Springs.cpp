// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "simcore/coupling/Springs.h"
#include "simcore/embed/Bind.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

std::vector<CoupledPart> partsOf(const Joint& joint) {
  std::vector<CoupledPart> parts;
  for (const Part& part : joint.parts) parts.push_back({&part, boundsOf(*part.visual).center()});
  return parts;
}

double total(const std::vector<CouplingSpring>& springs) {
  double sum = 0;
  for (const CouplingSpring& spring : springs) sum += spring.stiffness;
  return sum;
}

TEST(Springs, totalStiffnessDoesNotDependOnTheMesh) {
  for (const int cells : {1, 2, 4, 5}) {
    Joint joint = scenes::figure4Joint();
    joint.parts[1].volume = std::make_shared<TetMesh>(scenes::boxVolume(Vec3(-0.02, 0, 0), Vec3(0.02, 0.02, 0.02), cells, cells, cells));
    const auto springs = deriveSprings(joint, 0, partsOf(joint));
    ASSERT_TRUE(springs.ok());
    EXPECT_NEAR(total(*springs), 1e8 * 0.02 * 0.02, 1e-9 * 4e4) << cells;
    EXPECT_GE(springs->size(), 4u);
  }
}

TEST(Springs, haveNoLengthAtRest) {
  const Joint joint = scenes::figure4Joint();
  const auto parts = partsOf(joint);
  for (const CouplingSpring& spring : deriveSprings(joint, 1, parts).value()) {
    const Vec3 a = boundPosition(spring.a, joint.parts[1].volume->nodes);
    EXPECT_LT((a - (parts[2].centre + spring.b.r_B)).norm(), 1e-15);
    EXPECT_GT(spring.stiffness, 0);
    EXPECT_NEAR(spring.damping, 1e-3 * spring.stiffness, 1e-12 * spring.stiffness);
  }
}

TEST(Springs, softOnSoftEndsInTheOtherMesh) {
  Joint joint = scenes::figure4Joint();
  joint.parts[2] = scenes::boxPart("right", 3, PartKind::Soft, Vec3(0.02, 0, 0), Vec3(0.05, 0.02, 0.02), 3);
  for (const CouplingSpring& spring : deriveSprings(joint, 1, partsOf(joint)).value()) {
    const Vec3 a = boundPosition(spring.a, joint.parts[1].volume->nodes), b = boundPosition(spring.b, joint.parts[2].volume->nodes);
    EXPECT_LT((a - b).norm(), 1e-12);
  }
}

TEST(Springs, rigidOnRigidTakesFourPoints) {
  Joint joint = scenes::figure4Joint();
  Part& left = joint.parts[0];
  left.regions.push_back(scenes::regionIn(left, "side", Box3(Vec3(-1, -1, -0.001), Vec3(1, 1, 0.001))));
  joint.couplings.push_back({"c13", "left", "right", "side", 1e7, 0});
  const auto springs = deriveSprings(joint, 2, partsOf(joint)).value();
  EXPECT_EQ(springs.size(), 4u) << "a rigid body knows no more of a region than its moments";
  EXPECT_NEAR(total(springs), 1e7 * 0.03 * 0.02, 1e-6);
}

TEST(Springs, unknownAndTooSmallRegionsAreNamed) {
  Joint joint = scenes::figure4Joint();
  joint.couplings[0].regionA = "nowhere";
  EXPECT_EQ(deriveSprings(joint, 0, partsOf(joint)).error().fault, Fault::UnknownId);
  joint.couplings[0].regionA = "none";
  joint.parts[1].regions.push_back({"none", "none", "other", SurfaceKind::Visual, {}});
  const Error error = deriveSprings(joint, 0, partsOf(joint)).error();
  EXPECT_EQ(error.fault, Fault::TooFewSprings);
  EXPECT_EQ(error.place.part, "c12");
}

}  // namespace
}  // namespace glenoid
