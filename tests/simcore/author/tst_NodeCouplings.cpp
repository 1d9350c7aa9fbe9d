// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/author/NodeCouplings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>

#include "simcore/author/MirrorJoint.h"
#include "simcore/mesh/NodePatch.h"
#include "simcore/spatial/TriangleTree.h"
#include "tests/simcore/author/OverlappingParts.h"

namespace glenoid {
namespace {

NodeCoupling bandAtBall() {
  NodeCoupling wish;
  wish.coupling.id = "band-ball";
  wish.coupling.partA = "band";
  wish.coupling.partB = "ball";
  wish.coupling.stiffnessPerNode = 500;
  return wish;
}

TEST(NodeCouplings, byDistanceAreTheNodesNearOrInsideTheOtherPart) {
  JointRecipe recipe = test::overlappingParts();
  recipe.nodeCouplings = {bandAtBall()};
  recipe.nodeCouplings[0].within = 2e-3;
  const auto joint = buildJoint(recipe);
  ASSERT_TRUE(joint.ok()) << toLogLine(joint.error());
  ASSERT_EQ(joint->couplings.size(), 1u);
  EXPECT_TRUE(joint->couplings[0].regionA.empty());
  EXPECT_TRUE(joint->parts[1].regions.empty()) << "no region is made";
  const TetMesh& cells = *joint->parts[1].volume;
  const TriangleTree ball(*joint->parts[0].visual);
  std::vector<int> expected;
  for (const int node : usedNodes(cells))
    if (ball.signedDistance(cells.nodes[node]) <= 2e-3) expected.push_back(node);
  EXPECT_GT(expected.size(), 5u);
  EXPECT_LT(expected.size(), cells.nodes.size());
  EXPECT_EQ(joint->couplings[0].nodesA, expected);

  recipe.nodeCouplings[0].centre_W = Vec3(0.012, 0, 0.024);
  recipe.nodeCouplings[0].radius = 0.012;
  const auto limited = buildJoint(recipe);
  ASSERT_TRUE(limited.ok()) << toLogLine(limited.error());
  std::erase_if(expected, [&](int node) { return (cells.nodes[node] - Vec3(0.012, 0, 0.024)).norm() > 0.012; });
  EXPECT_EQ(limited->couplings[0].nodesA, expected);
  recipe.nodeCouplings[0].within.reset();
  const auto ballAlone = buildJoint(recipe);
  ASSERT_TRUE(ballAlone.ok());
  EXPECT_GT(ballAlone->couplings[0].nodesA.size(), expected.size());
  for (const int node : ballAlone->couplings[0].nodesA) EXPECT_LE((cells.nodes[node] - Vec3(0.012, 0, 0.024)).norm(), 0.012);
}

TEST(NodeCouplings, pointsTakeTheNearestNodesAlsoInOtherCells) {
  JointRecipe recipe = test::overlappingParts();
  NodeCoupling wish = bandAtBall();
  wish.points_W = {Vec3(-0.008, -0.01, 0.024), Vec3(0.008, -0.01, 0.024), Vec3(0, 0.01, 0.024), Vec3(0, 0.01, 0.024)};
  recipe.nodeCouplings = {wish};
  for (const int tetrahedra : {400, 1200}) {
    recipe.parts[1].tetrahedra = tetrahedra;
    const auto joint = buildJoint(recipe);
    ASSERT_TRUE(joint.ok()) << toLogLine(joint.error());
    const TetMesh& cells = *joint->parts[1].volume;
    const std::vector<int>& nodes = joint->couplings[0].nodesA;
    EXPECT_EQ(nodes.size(), 3u) << "two points of one node are one spring";
    for (const Vec3& point : wish.points_W) {
      double nearest = 1, chosen = 1;
      for (const Vec3& node : cells.nodes) nearest = std::min(nearest, (node - point).norm());
      for (const int node : nodes) chosen = std::min(chosen, (cells.nodes[node] - point).norm());
      EXPECT_EQ(chosen, nearest);
    }
  }
}

TEST(NodeCouplings, whatIsNotThereIsNamedWithItsFigures) {
  const Joint built = *buildJoint(test::overlappingParts());
  Joint joint = built;
  NodeCoupling wish = bandAtBall();
  wish.within = 1e-3;
  joint.parts[0].visual = std::make_shared<const TriMesh>(shapes::moved(*joint.parts[0].visual, test::shiftedBy(1, 0, 0)));
  const Error far = addNodeCoupling(joint, wish).error();
  EXPECT_EQ(far.fault, Fault::NothingNear);
  EXPECT_EQ(far.place.part, "band-ball");
  EXPECT_NE(far.arguments[0].find("“band-ball” of band to ball (nearest node "), std::string::npos) << far.arguments[0];
  EXPECT_TRUE(joint.couplings.empty());
  wish.radius = 1e-3;
  wish.centre_W = Vec3(5, 5, 5);
  EXPECT_NE(addNodeCoupling(joint, wish).error().arguments[0].find("no node of band lies in its ball"), std::string::npos);
  wish = bandAtBall();
  wish.points_W = {Vec3(0, 0, 0.024), Vec3(0.01, 0, 0.024), Vec3(0, 0, 1)};
  const Error point = addNodeCoupling(joint, wish).error();
  EXPECT_EQ(point.fault, Fault::NothingNear);
  EXPECT_NE(point.arguments[0].find("point 3: nearest node "), std::string::npos) << point.arguments[0];

  joint = built;
  wish.points_W = {Vec3(0, 0, 0.024), Vec3(0, 0, 0.024), Vec3(0.02, 0, 0.024)};
  EXPECT_EQ(addNodeCoupling(joint, wish).error().arguments, (Arguments{"few", "2"}));
  joint = built;
  wish = bandAtBall();
  std::swap(wish.coupling.partA, wish.coupling.partB);
  wish.within = 1e-3;
  EXPECT_EQ(addNodeCoupling(joint, wish).error().arguments, (Arguments{"rigid", "ball"}));
  wish.coupling.partB = "moon";
  EXPECT_EQ(addNodeCoupling(joint, wish).error().fault, Fault::UnknownId);
}

TEST(NodeCouplings, keepTheirNodesInTheMirror) {
  JointRecipe recipe = test::overlappingParts();
  recipe.nodeCouplings = {bandAtBall()};
  recipe.nodeCouplings[0].within = 2e-3;
  const Joint joint = *buildJoint(recipe), mirrored = mirroredJoint(joint), back = mirroredJoint(mirrored);
  EXPECT_EQ(mirrored.couplings[0].nodesA, joint.couplings[0].nodesA);
  for (const int node : joint.couplings[0].nodesA)
    EXPECT_EQ(mirrored.parts[1].volume->nodes[node], Vec3(joint.parts[1].volume->nodes[node].cwiseProduct(Vec3(1, 1, -1))));
  EXPECT_EQ(back.couplings, joint.couplings);
  EXPECT_EQ(*back.parts[1].volume, *joint.parts[1].volume);
  recipe.mirrored = true;
  EXPECT_EQ(buildJoint(recipe)->couplings[0].nodesA, joint.couplings[0].nodesA);
}

}  // namespace
}  // namespace glenoid
