// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/author/BuildJoint.h"

#include <gtest/gtest.h>

#include <cstdio>
#include <cstdlib>
#include <limits>

#include "simcore/mesh/MeshHealth.h"
#include "simcore/mesh/TetTools.h"
#include "simcore/spatial/Intersect.h"
#include "simcore/spatial/TriangleTree.h"
#include "tests/simcore/mesh/Shapes.h"

using namespace glenoid;

namespace {

std::shared_ptr<const TriMesh> shared(TriMesh mesh) {
  return std::make_shared<const TriMesh>(std::move(mesh));
}

Pose at(double x, double y, double z) {
  Pose pose;
  pose.p_WB = Vec3(x, y, z);
  return pose;
}

Part part(const std::string& id, int number, PartKind kind, TriMesh collision) {
  Part p;
  p.id = id;
  p.number = number;
  p.kind = kind;
  p.visual = p.collision = shared(std::move(collision));
  return p;
}

/// Independent of what separateCollision measures: vertices against faces both ways, and no triangles in
/// common. Edges against edges are sampled at 41 points.
double sampledDistance(const TriMesh& a, const TriMesh& b) {
  if (!intersectingTriangles(a, b).empty()) return 0;
  double least = 1;
  for (const auto& [p, q] : {std::pair(&a, &b), std::pair(&b, &a)}) {
    const TriangleTree tree(*q);
    for (const auto& t : p->triangles)
      for (int i = 0; i < 3; ++i)
        for (int s = 0; s <= 40; ++s) {
          const Vec3 x = p->vertices[t[i]] + s / 40.0 * (p->vertices[t[(i + 1) % 3]] - p->vertices[t[i]]);
          least = std::min(least, tree.closest(x).distance);
          if (tree.inside(x)) return 0;
        }
  }
  return least;
}

JointRecipe smallJoint() {
  JointRecipe recipe;
  recipe.id = "small";
  PartRecipe ball, sheet;
  ball.id = "bone", ball.number = 1;
  ball.visual = shared(shapes::sphere(0.02));
  ball.collisionTriangles = 100;
  sheet.id = "sheet", sheet.number = 2, sheet.kind = PartKind::Soft;
  // Lies on the ball and 1 mm in it.
  sheet.visual = shared(shapes::moved(shapes::sheet(0.05, 0.02, 0.003, 1.0), at(0, 0, 0.0205)));
  sheet.collisionTriangles = 86, sheet.tetrahedra = 80;
  recipe.parts = {sheet, ball};
  recipe.clearance = 0.0005;
  return recipe;
}

}  // namespace

TEST(SeparateCollision, overlappingPlatesCameApart) {
  // Two plates of 3 mm, 1 mm in each other, their facets unlike.
  Joint joint;
  joint.parts.push_back(part("lower", 1, PartKind::Soft, shapes::sheet(0.06, 0.03, 0.003, 0.01, 12, 14)));
  joint.parts.push_back(
      part("upper", 2, PartKind::Soft,
           shapes::moved(shapes::sheet(0.05, 0.035, 0.003, 0.01, 14, 11), at(0.004, 0.003, 0.002))));
  const auto lower = joint.parts[0].collision, upper = joint.parts[1].collision;
  ASSERT_FALSE(intersectingTriangles(*lower, *upper).empty());
  const auto report = separateCollision(joint, 0.0005);
  ASSERT_TRUE(report.ok());
  EXPECT_TRUE(report->left.empty());
  EXPECT_EQ(joint.parts[0].collision, lower) << "the one of lower number stays";
  EXPECT_GT(report->movedVertices, 0);
  // Half a millimetre beyond the overlap, and not much more.
  EXPECT_GT(report->maxShift, 0.001);
  EXPECT_LT(report->maxShift, 0.004);
  EXPECT_GE(sampledDistance(*lower, *joint.parts[1].collision), 0.0005 * (1 - 1e-9));
  EXPECT_TRUE(healthOf(*joint.parts[1].collision).healthy());
  EXPECT_EQ(countSelfIntersections(*joint.parts[1].collision), 0);
  // The plate gave way as a whole: it was not squeezed.
  EXPECT_NEAR(enclosedVolume(*joint.parts[1].collision) / enclosedVolume(*upper), 1, 0.15);
  if (std::getenv("GLENOID_PRINT"))
    std::printf("%d iterations, %.2f mm, volume %.3f\n", report->iterations, 1e3 * report->maxShift,
                enclosedVolume(*joint.parts[1].collision) / enclosedVolume(*upper));
}

TEST(SeparateCollision, softYieldsToRigidWhateverTheNumber) {
  Joint joint;
  joint.parts.push_back(
      part("tendon", 1, PartKind::Soft, shapes::moved(shapes::capsule(0.003, 0.04, 8, 14), at(0.021, 0, 0))));
  joint.parts.push_back(part("bone", 2, PartKind::Rigid, shapes::sphere(0.02, 16, 11)));
  const auto bone = joint.parts[1].collision;
  const auto report = separateCollision(joint, 0.0003);
  ASSERT_TRUE(report.ok());
  EXPECT_TRUE(report->left.empty());
  EXPECT_EQ(joint.parts[1].collision, bone);
  EXPECT_GE(sampledDistance(*joint.parts[0].collision, *bone), 0.0003 * (1 - 1e-9));
}

TEST(SeparateCollision, excludedAndDistantPairsAreLeftAlone) {
  Joint joint;
  joint.parts.push_back(part("a", 1, PartKind::Soft, shapes::sphere(0.02, 16, 11)));
  joint.parts.push_back(
      part("b", 2, PartKind::Soft, shapes::moved(shapes::sphere(0.02, 16, 11), at(0.03, 0, 0))));
  joint.parts.push_back(
      part("c", 3, PartKind::Soft, shapes::moved(shapes::sphere(0.02, 16, 11), at(1, 0, 0))));
  joint.exclusions.push_back({"b", "a", "grown together"});
  const auto report = separateCollision(joint, 0.0005);
  ASSERT_TRUE(report.ok());
  EXPECT_EQ(report->movedVertices, 0);
  EXPECT_EQ(report->iterations, 0);
  EXPECT_TRUE(report->left.empty());
}

TEST(SeparateCollision, whatCannotBeHelpedIsReported) {
  Joint joint;
  joint.parts.push_back(part("shell", 1, PartKind::Rigid, shapes::sphere(0.05, 16, 11)));
  joint.parts.push_back(part("core", 2, PartKind::Rigid, shapes::sphere(0.01, 16, 11)));
  const auto report = separateCollision(joint, 0.0005, 5);
  ASSERT_TRUE(report.ok());
  ASSERT_EQ(report->left.size(), 1u);
  EXPECT_EQ(report->left[0].partA, "shell");
  EXPECT_EQ(report->left[0].partB, "core");
  EXPECT_EQ(report->left[0].distance, 0);
  EXPECT_EQ(separateCollision(joint, 0).error().fault, Fault::OutOfRange);
  joint.parts[1].collision = nullptr;
  EXPECT_EQ(separateCollision(joint, 0.001).error().place.part, "core");
}

TEST(BuildJoint, partsComeOutAsTheRecipeAsks) {
  BuildReport report;
  std::vector<double> progress;
  const auto joint = buildJoint(
      smallJoint(), [&](const std::string&, double done) { return progress.push_back(done), true; }, &report);
  ASSERT_TRUE(joint.ok()) << toLogLine(joint.error());
  ASSERT_EQ(joint->parts.size(), 2u);
  const Part &bone = joint->parts[0], &sheet = joint->parts[1];
  EXPECT_EQ(bone.id, "bone") << "ascending by number";
  EXPECT_EQ(bone.collision->triangles.size(), 100u);
  EXPECT_EQ(bone.volume, nullptr);
  EXPECT_EQ(sheet.collision->triangles.size(), 86u);
  ASSERT_NE(sheet.volume, nullptr);
  EXPECT_NEAR(static_cast<double>(sheet.volume->tets.size()), 80, 4);
  EXPECT_GT(sheet.cellSize, 0);
  EXPECT_TRUE(healthOf(*sheet.volume).healthy());
  EXPECT_TRUE(report.separation.left.empty());
  EXPECT_GE(sampledDistance(*bone.collision, *sheet.collision), 0.0005 * (1 - 1e-9));
  ASSERT_EQ(report.parts.size(), 2u);
  EXPECT_EQ(report.parts[1].collisionCuts, 0);
  EXPECT_TRUE(std::is_sorted(progress.begin(), progress.end()));
  EXPECT_LE(progress.back(), 1);
  const auto again = buildJoint(smallJoint());
  EXPECT_EQ(*again->parts[1].volume, *sheet.volume);
  EXPECT_EQ(*again->parts[1].collision, *sheet.collision);
}

TEST(BuildJoint, ownCollisionSurfaceAndCellSizeAreKept) {
  JointRecipe recipe = smallJoint();
  recipe.clearance = 0;
  recipe.parts[0].collision = shared(*recipe.parts[0].visual);
  recipe.parts[0].cellSize = 0.01;
  recipe.parts[1].collisionTriangles = 0;
  const auto joint = buildJoint(recipe);
  ASSERT_TRUE(joint.ok());
  EXPECT_EQ(joint->parts[1].collision, recipe.parts[0].collision);
  EXPECT_EQ(joint->parts[0].collision, recipe.parts[1].visual);
  EXPECT_EQ(joint->parts[1].cellSize, 0.01);
}

TEST(BuildJoint, faultsNameThePart) {
  JointRecipe recipe = smallJoint();
  TriMesh open = *recipe.parts[0].visual;
  open.triangles.pop_back();
  recipe.parts[0].visual = shared(open);
  EXPECT_EQ(buildJoint(recipe).error().fault, Fault::MeshNotClosed);
  EXPECT_EQ(buildJoint(recipe).error().place.part, "sheet");
  recipe.parts[0].visual = nullptr;
  EXPECT_EQ(buildJoint(recipe).error().fault, Fault::BadMesh);
  recipe = smallJoint();
  recipe.parts[0].tetrahedra = -1;
  EXPECT_EQ(buildJoint(recipe).error().fault, Fault::OutOfRange);
  EXPECT_EQ(buildJoint(recipe).error().place.part, "sheet");
  EXPECT_EQ(
      buildJoint(smallJoint(), [](const std::string&, double done) { return done < 0.3; }).error().fault,
      Fault::Cancelled);
}
