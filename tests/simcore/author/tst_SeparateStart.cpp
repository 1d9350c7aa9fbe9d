// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/author/SeparateStart.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "simcore/author/CagedPart.h"
#include "simcore/author/MakeCage.h"
#include "simcore/embed/Bind.h"
#include "simcore/mesh/MeshHealth.h"
#include "simcore/mesh/TetTools.h"
#include "simcore/scene/JointFile.h"
#include "simcore/scene/Start.h"
#include "simcore/spatial/Intersect.h"
#include "simcore/spatial/TriangleTree.h"
#include "tests/simcore/author/OverlappingParts.h"

namespace glenoid {
namespace {

Joint overlapping() {
  static const Result<Joint> joint = buildJoint(test::overlappingParts());
  EXPECT_TRUE(joint.ok()) << toLogLine(joint.error());
  return *joint;
}

TEST(MakeCage, theCageIsClosedAndHoldsEveryNode) {
  const Joint joint = overlapping();
  for (const int handles : {20, 60, 200}) {
    const auto cage = makeCage(joint.parts[1], handles);
    ASSERT_TRUE(cage.ok()) << toLogLine(cage.error());
    EXPECT_TRUE(healthOf({cage->rest_W, cage->triangles}).healthy());
    EXPECT_NEAR(static_cast<double>(cage->rest_W.size()), handles, 0.1 * handles);
    EXPECT_EQ(cage->rest_W, cage->moved_W);
    const TriangleTree tree({cage->rest_W, cage->triangles});
    for (const Vec3& node : joint.parts[1].volume->nodes) EXPECT_TRUE(tree.inside(node));
  }
}

TEST(MakeCage, whatCannotHaveACageIsRefused) {
  const Joint joint = overlapping();
  EXPECT_EQ(makeCage(joint.parts[0], 60).error().fault, Fault::Unusable);
  EXPECT_EQ(makeCage(joint.parts[1], 4).error().fault, Fault::OutOfRange);
}

TEST(CagedPart, theStiffnessIsSymmetricAndResistsEverything) {
  const Joint joint = overlapping();
  const auto caged = CagedPart::make(joint.parts[1], *makeCage(joint.parts[1], 30));
  ASSERT_TRUE(caged.ok());
  const MatX K = caged->stiffness();
  EXPECT_LT((K - K.transpose()).norm(), 1e-12 * K.norm());
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<MatX>(K).eigenvalues()[0], 0);
}

TEST(CagedPart, moveTheCageAndNodesAndSurfaceGoWithIt) {
  const Joint joint = overlapping();
  auto caged = CagedPart::make(joint.parts[1], *makeCage(joint.parts[1], 30));
  ASSERT_TRUE(caged.ok());
  VecX shifts(3 * caged->handleCount());
  for (int j = 0; j < caged->handleCount(); ++j) shifts.segment<3>(3 * j) = Vec3(0.001, 0.002, -0.003);
  caged->setShifts(shifts);
  for (std::size_t i = 0; i < caged->nodes().size(); ++i)
    EXPECT_LT((caged->nodes()[i] - joint.parts[1].volume->nodes[i] - Vec3(0.001, 0.002, -0.003)).norm(), 1e-15);
  shifts[4] += 0.01;
  caged->setShifts(shifts);
  const auto bound = bindToTets(*joint.parts[1].volume, joint.parts[1].collision->vertices);
  for (std::size_t v = 0; v < bound.size(); ++v)
    EXPECT_LT((caged->collision().vertices[v] - boundPosition(bound[v], caged->nodes())).norm(), 1e-15);
}

TEST(Overlaps, depthAndCutsAreThoseOfTwoBalls) {
  Joint joint;
  for (const double x : {0.0, 0.018}) {
    Part part;
    part.id = x == 0 ? "a" : "b";
    part.number = x == 0 ? 1 : 2;
    part.visual = part.collision = std::make_shared<const TriMesh>(shapes::moved(shapes::sphere(0.01), test::shiftedBy(x, 0, 0)));
    joint.parts.push_back(part);
  }
  const auto overlaps = overlapsAtStart(joint);
  ASSERT_TRUE(overlaps.ok());
  ASSERT_EQ(overlaps->size(), 1u);
  EXPECT_NEAR((*overlaps)[0].depth, 0.002, 1e-4);  // the balls are faceted
  EXPECT_EQ((*overlaps)[0].cuts, intersectingTriangles(*joint.parts[0].collision, *joint.parts[1].collision));
  joint.exclusions = {{"b", "a", ""}};
  EXPECT_TRUE(overlapsAtStart(joint)->empty());
  EXPECT_TRUE(pairsThatMayCollide(joint).empty());
}

TEST(Overlaps, aSwallowedPartIsAnOverlapWithoutCuts) {
  Joint joint;
  for (const double radius : {0.01, 0.002}) {
    Part part;
    part.id = radius == 0.01 ? "whale" : "fish";
    part.number = radius == 0.01 ? 1 : 2;
    part.visual = part.collision = std::make_shared<const TriMesh>(shapes::sphere(radius, 12, 9));
    joint.parts.push_back(part);
  }
  const auto check = checkStart(joint);
  ASSERT_TRUE(check.ok());
  EXPECT_EQ(check->proof.cuts, 0);
  ASSERT_EQ(check->overlaps.size(), 1u);
  EXPECT_FALSE(check->holds());
}

TEST(SeparateStart, soBonesStayAndTissueGivesWayUntilNothingCuts) {
  Joint joint = overlapping();
  const Joint before = joint;
  StartWishes wishes;
  wishes.clearance = 5e-4;
  const auto outcome = separateStart(joint, wishes);
  ASSERT_TRUE(outcome.ok()) << toLogLine(outcome.error());
  EXPECT_GE(outcome->overlapsBefore, 2);
  EXPECT_GT(outcome->depthBefore, 3e-3);
  EXPECT_TRUE(outcome->check.holds());
  EXPECT_EQ(joint.startProof, outcome->check.proof);
  EXPECT_EQ(joint.startProof->of, startHash(joint));
  // Measured here on surfaces rebuilt from the nodes, not by what the function says of itself.
  const auto surfaces = startSurfaces(joint, SurfaceKind::Collision);
  for (const auto& [a, b] : {std::pair(0, 1), {0, 2}, {1, 2}}) {
    EXPECT_TRUE(intersectingTriangles((*surfaces)[a], (*surfaces)[b]).empty()) << a << " " << b;
    const TriangleTree tree((*surfaces)[a]);
    for (const Vec3& p : (*surfaces)[b].vertices) EXPECT_FALSE(tree.inside(p));
  }
  for (const int part : {1, 2}) {
    const auto nodes = startNodes(joint, joint.parts[part]);
    const TetMesh moved{*nodes, joint.parts[part].volume->tets};
    for (int tet = 0; tet < static_cast<int>(moved.tets.size()); ++tet)
      EXPECT_GT(tetVolume(moved, tet), 0.1 * tetVolume(*joint.parts[part].volume, tet));
    EXPECT_EQ(joint.parts[part].volume, before.parts[part].volume);  // rest is rest
  }
  EXPECT_FALSE(findCage(joint, "ball"));
}

TEST(SeparateStart, theSameTwice) {
  Joint a = overlapping(), b = overlapping();
  ASSERT_TRUE(separateStart(a, {}).ok());
  ASSERT_TRUE(separateStart(b, {}).ok());
  EXPECT_EQ(jointHash(a), jointHash(b));
}

TEST(SeparateStart, aCancelledOneLeavesTheJointAlone) {
  Joint joint = overlapping();
  const std::string hash = jointHash(joint);
  const auto outcome = separateStart(joint, {}, [](double, int) { return false; });
  ASSERT_FALSE(outcome.ok());
  EXPECT_EQ(outcome.error().fault, Fault::Cancelled);
  EXPECT_EQ(jointHash(joint), hash);
}

TEST(SeparateStart, whatMayNotMoveIsReportedAsItIs) {
  Joint joint = overlapping();
  StartWishes wishes;
  wishes.parts = {"strap"};  // the band stays in the ball
  wishes.iterations = 3;
  wishes.refinements = 0;
  const auto outcome = separateStart(joint, wishes);
  ASSERT_TRUE(outcome.ok());
  EXPECT_FALSE(outcome->check.holds());
  EXPECT_GT(joint.startProof->cuts, 0);
  EXPECT_FALSE(findCage(joint, "band"));
  wishes.parts = {"sling"};
  EXPECT_EQ(separateStart(joint, wishes).error().fault, Fault::UnknownId);
  wishes = {};
  wishes.clearance = 0;
  EXPECT_EQ(separateStart(joint, wishes).error().fault, Fault::OutOfRange);
}

TEST(SeparateStart, nothingOverlapsSoNothingMoves) {
  JointRecipe recipe = test::overlappingParts();
  recipe.parts.pop_back();
  recipe.parts[0].visual = std::make_shared<const TriMesh>(shapes::sphere(0.01));
  auto joint = buildJoint(recipe);
  ASSERT_TRUE(joint.ok());
  const auto outcome = separateStart(*joint, {});
  ASSERT_TRUE(outcome.ok());
  EXPECT_EQ(outcome->overlapsBefore, 0);
  EXPECT_TRUE(joint->cages.empty());
  EXPECT_TRUE(outcome->check.holds());
}

TEST(SeparateStart, theProofIsOfThisJointOnly) {
  Joint joint = overlapping();
  ASSERT_TRUE(separateStart(joint, {}).ok());
  EXPECT_EQ(joint.startProof->of, startHash(joint));
  joint.cages[0].moved_W[0].x() += 1e-9;
  EXPECT_NE(joint.startProof->of, startHash(joint));
}

}  // namespace
}  // namespace glenoid
