// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "resources/generate/Coarse.h"
#include "resources/generate/Shoulder.h"
#include "simcore/mesh/MeshHealth.h"
#include "simcore/scene/JointFile.h"
#include "simcore/shape/Field.h"
#include "simcore/shape/Relax.h"
#include "simcore/shape/Tube.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid::generate {
namespace {

TEST(Isosurface, ofASphereIsClosedAndHasItsVolume) {
  TriMesh mesh = isosurface(sphere(Vec3(1, 2, 3), 10), Box3(Vec3(-12, -11, -10), Vec3(14, 15, 16)), 0.8);
  relax(mesh, sphere(Vec3(1, 2, 3), 10), 2);
  EXPECT_TRUE(healthOf(mesh).healthy());
  // Chords of 0.8 mm on a radius of 10 sink by 0.8²/(8·10) at most: 0.25 % of the volume.
  EXPECT_NEAR(enclosedVolume(mesh), 4.0 / 3 * 3.14159265 * 1000, 0.005 * 4189);
}

TEST(Swept, putsTheMiddleOfASectionWhereItSays) {
  // A section that reaches farther to the right than to the left, about (3, 1): its outline's middle lies
  // there all the same, half way between two equal sections.
  const Section section{0, {3, 1}, {-4, 0}, {8, 0}, {0, 5}, {0, -5}};
  Section other = section;
  other.z = 20;
  const Field body = swept(Frame{}, {section, other}, 1);
  std::vector<Vec3> outline;
  for (int i = 0; i < 360; ++i) {
    const double a = i * 3.14159265 / 180;
    outline.push_back(settle(body, Vec3(3, 1, 10), Vec3(std::cos(a), std::sin(a), 0), 0, 0));
  }
  Vec3 middle = Vec3::Zero();
  double length = 0, left = 1e9, right = -1e9;
  for (std::size_t i = 0, j = outline.size() - 1; i < outline.size(); j = i++) {
    const double piece = (outline[i] - outline[j]).norm();
    middle += piece * 0.5 * (outline[i] + outline[j]);
    length += piece;
    left = std::min(left, outline[i].x()), right = std::max(right, outline[i].x());
  }
  EXPECT_LT((middle / length - Vec3(3, 1, 10)).norm(), 0.1);
  EXPECT_NEAR(right - left, 12, 0.2);
  EXPECT_LT(body(Vec3(3, 1, 10)), -4);
  EXPECT_NEAR(body(Vec3(3, 1, 25)), 5, 0.1) << "above its end";
}

TEST(Turned, hasItsProfileAllAround) {
  const Field spool = turned(Frame{}, {{-8, 10}, {-4, 10}, {0, 7}, {4, 10}, {8, 10}}, 1);
  for (const Vec3& around : {Vec3(0, 1, 0), Vec3(0, -1, 0), Vec3(0, 0.6, 0.8)}) {
    EXPECT_NEAR(spool(7 * around), 0, 0.1) << "the groove";
    EXPECT_NEAR(spool(Vec3(5.5, 0, 0) + 10 * around), 0, 0.3) << "the lip";
  }
  EXPECT_NEAR(spool(Vec3(10, 0, 0)), 2, 0.1) << "beyond its end";
}

TEST(CoarseOf, liesOnWhatMattersWithFewTriangles) {
  const Field ball = sphere(Vec3::Zero(), 24);
  TriMesh fine = isosurface(ball, Box3(Vec3::Constant(-27), Vec3::Constant(27)), 2);
  relax(fine, ball, 2);
  const TriMesh coarse = coarseOf(fine, ball, 60, [](const Vec3& p) { return p.x() > 0 ? 1 : 0.01; });
  EXPECT_TRUE(healthOf(coarse).healthy());
  EXPECT_EQ(countSelfIntersections(coarse), 0);
  EXPECT_LE(coarse.triangles.size(), 60u);
  const TriangleTree tree(coarse);
  double farthest = 0;
  for (const Vec3& p : fine.vertices)
    if (p.x() > 4) farthest = std::max(farthest, tree.closest(p).distance);
  EXPECT_LT(farthest, 1.5);
}

TEST(Settle, findsTheSurfaceFromBothSides) {
  const Field ball = sphere(Vec3::Zero(), 10);
  const Vec3 up = Vec3::UnitY();
  EXPECT_NEAR(settle(ball, Vec3(0, 15, 0), up, 1, 8).y(), 11, 1e-3);
  EXPECT_NEAR(settle(ball, Vec3(0, 8, 0), up, 1, 8).y(), 11, 1e-3);
  EXPECT_NEAR(settle(ball, Vec3(0, 15, 0), up, 1, 2).y(), 15, 1e-12) << "out of reach";
}

TEST(Sweep, hasTheTrianglesItPromises) {
  Tube tube;
  tube.stations = {{Vec3(0, 0, 0), Vec3::UnitY(), 3, 2, 0, 0, 0},
                   {Vec3(0, 0, 20), Vec3::UnitY(), 3, 2, 0, 0, 0}};
  EXPECT_EQ(sweep(tube, 6, 7).triangles.size(), 84u);
  tube.flatEnds = true;
  EXPECT_EQ(sweep(tube, 4, 4).triangles.size(), 28u);
  EXPECT_TRUE(healthOf(sweep(tube, 4, 4)).healthy());
}

TEST(KeepClear, movesASurfaceOutOfAnObstacle) {
  Tube tube;
  tube.stations = {{Vec3(0, 9, -20), Vec3::UnitY(), 3, 2, 0, 0, 0},
                   {Vec3(0, 9, 20), Vec3::UnitY(), 3, 2, 0, 0, 0}};
  TriMesh mesh = sweep(tube, 6, 9);
  const Field ball = sphere(Vec3::Zero(), 10);
  keepClear(mesh, ball, 0.5);
  for (const auto& t : mesh.triangles)
    EXPECT_GT(ball((mesh.vertices[t[0]] + mesh.vertices[t[1]] + mesh.vertices[t[2]]) / 3), 0.45);
}

/// Dents are pressed into the joint afterwards, by `glenoid joint dents`.
Joint withoutDents(Joint joint) {
  for (Part& part : joint.parts) part.dents = nullptr;
  return joint;
}

TEST(GenerateShoulder, givesTheJointThatShips) {
  const Result<Joint> made = makeShoulder();
  ASSERT_TRUE(made.ok());
  const Result<Joint> shipped = loadJoint(GLENOID_SOURCE_DIR "/resources/joints/shoulder.joint");
  ASSERT_TRUE(shipped.ok()) << toLogLine(shipped.error());
  EXPECT_EQ(jointHash(*made), jointHash(withoutDents(*shipped))) << "run generate_shoulder and commit its answer";
}

TEST(GenerateShoulder, givesTheLayersForPalpationThatShip) {
  const Result<Joint> made = makePalpation();
  ASSERT_TRUE(made.ok());
  const Result<Joint> shipped = loadJoint(GLENOID_SOURCE_DIR "/resources/joints/shoulder-superficial.joint");
  ASSERT_TRUE(shipped.ok()) << toLogLine(shipped.error());
  EXPECT_EQ(jointHash(*made), jointHash(withoutDents(*shipped)))
      << "run generate_shoulder OUT superficial and commit its answer";
}

TEST(GenerateShoulder, givesTheJointWithItsCapsuleThatShips) {
  const Result<Joint> made = makeWithCapsule();
  ASSERT_TRUE(made.ok());
  const Result<Joint> shipped = loadJoint(GLENOID_SOURCE_DIR "/resources/joints/shoulder-capsule.joint");
  ASSERT_TRUE(shipped.ok()) << toLogLine(shipped.error());
  EXPECT_EQ(jointHash(*made), jointHash(withoutDents(*shipped))) << "run generate_shoulder OUT capsule and commit its answer";
}

}  // namespace
}  // namespace glenoid::generate
