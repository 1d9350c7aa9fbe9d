// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "resources/generate/Field.h"
#include "resources/generate/Relax.h"
#include "resources/generate/Shoulder.h"
#include "resources/generate/Tube.h"
#include "simcore/mesh/MeshHealth.h"
#include "simcore/scene/JointFile.h"

namespace glenoid::generate {
namespace {

TEST(Isosurface, ofASphereIsClosedAndHasItsVolume) {
  TriMesh mesh = isosurface(sphere(Vec3(1, 2, 3), 10), Box3(Vec3(-12, -11, -10), Vec3(14, 15, 16)), 0.8);
  relax(mesh, sphere(Vec3(1, 2, 3), 10), 2);
  EXPECT_TRUE(healthOf(mesh).healthy());
  // Chords of 0.8 mm on a radius of 10 sink by 0.8²/(8·10) at most: 0.25 % of the volume.
  EXPECT_NEAR(enclosedVolume(mesh), 4.0 / 3 * 3.14159265 * 1000, 0.005 * 4189);
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

TEST(GenerateShoulder, givesTheJointThatShips) {
  const Result<Joint> made = makeShoulder();
  ASSERT_TRUE(made.ok());
  const Result<Joint> shipped = loadJoint(GLENOID_SOURCE_DIR "/resources/joints/shoulder.joint");
  ASSERT_TRUE(shipped.ok()) << toLogLine(shipped.error());
  EXPECT_EQ(jointHash(*made), jointHash(*shipped)) << "run generate_shoulder and commit its answer";
}

TEST(GenerateShoulder, givesTheLayersForPalpationThatShip) {
  const Result<Joint> made = makePalpation();
  ASSERT_TRUE(made.ok());
  const Result<Joint> shipped = loadJoint(GLENOID_SOURCE_DIR "/resources/joints/shoulder-superficial.joint");
  ASSERT_TRUE(shipped.ok()) << toLogLine(shipped.error());
  EXPECT_EQ(jointHash(*made), jointHash(*shipped)) << "run generate_shoulder OUT superficial and commit its answer";
}

}  // namespace
}  // namespace glenoid::generate
