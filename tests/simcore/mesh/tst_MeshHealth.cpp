// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/mesh/MeshHealth.h"

#include <gtest/gtest.h>

#include <limits>

#include "simcore/mesh/Cleanup.h"
#include "tests/simcore/mesh/Shapes.h"

using namespace glenoid;

TEST(MeshHealth, closedShapesAreHealthyAndHaveTheirGenus) {
  const MeshHealth ball = healthOf(shapes::sphere(0.02));
  EXPECT_TRUE(ball.healthy());
  EXPECT_EQ(ball.genus, 0);
  EXPECT_EQ(ball.components, 1);
  // Inscribed in the sphere: 48 × 31 facets lose under one per cent.
  EXPECT_NEAR(ball.volume / (4.0 / 3 * M_PI * 8e-6), 0.995, 0.005);

  const MeshHealth ring = healthOf(shapes::torus(0.02, 0.004, 40, 12));
  EXPECT_TRUE(ring.healthy());
  EXPECT_EQ(ring.genus, 1);

  TriMesh two = shapes::box(Vec3::Zero(), Vec3::Ones());
  const TriMesh other = shapes::box(Vec3::Constant(2), Vec3::Constant(3));
  for (auto t : other.triangles) two.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
  two.vertices.insert(two.vertices.end(), other.vertices.begin(), other.vertices.end());
  EXPECT_EQ(healthOf(two).components, 2);
  EXPECT_EQ(healthOf(two).genus, 0);
  EXPECT_DOUBLE_EQ(healthOf(two).volume, 2);
  EXPECT_DOUBLE_EQ(healthOf(two).area, 12);
}

TEST(MeshHealth, namesEachDefect) {
  const TriMesh box = shapes::box(Vec3::Zero(), Vec3::Ones());
  TriMesh open = box;
  open.triangles.pop_back();
  EXPECT_EQ(healthOf(open).openEdges, 3);
  EXPECT_EQ(requireClosed(open).error().fault, Fault::MeshNotClosed);

  TriMesh turned = box;
  std::swap(turned.triangles[0][1], turned.triangles[0][2]);
  EXPECT_EQ(healthOf(turned).misorientedEdges, 3);
  EXPECT_EQ(requireClosed(turned).error().fault, Fault::BadMesh);

  TriMesh fin = box;
  fin.vertices.push_back(Vec3(-1, -1, -1));
  fin.triangles.push_back({0, 1, 8});
  EXPECT_EQ(healthOf(fin).nonManifoldEdges, 1);

  TriMesh pinched = box;  // a second box at the corner of the first, sharing that vertex
  const TriMesh other = shapes::box(Vec3::Ones(), Vec3::Constant(2));
  const auto shift = [](int i) { return i == 0 ? 7 : i + 7; };
  for (auto t : other.triangles) pinched.triangles.push_back({shift(t[0]), shift(t[1]), shift(t[2])});
  pinched.vertices.insert(pinched.vertices.end(), other.vertices.begin() + 1, other.vertices.end());
  EXPECT_EQ(healthOf(pinched).nonManifoldVertices, 1);
  EXPECT_EQ(healthOf(pinched).nonManifoldEdges, 0);
  EXPECT_FALSE(requireClosed(pinched).ok());

  EXPECT_EQ(requireClosed(reversed(box)).error().fault, Fault::BadMesh);

  TriMesh nan = box;
  nan.vertices[3].y() = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(requireClosed(nan).error().fault, Fault::NotFinite);

  TriMesh index = box;
  index.triangles[5][1] = 8;
  EXPECT_EQ(requireClosed(index, "labrum").error().fault, Fault::BadIndex);
  EXPECT_EQ(requireClosed(index, "labrum").error().place.part, "labrum");
  EXPECT_EQ(requireClosed(TriMesh{}).error().fault, Fault::BadMesh);
}

TEST(MeshHealth, flatTriangleIsDegenerate) {
  TriMesh mesh = shapes::box(Vec3::Zero(), Vec3::Ones());
  mesh.vertices.push_back(Vec3(0.5, 0, 0));  // on the edge 0–1
  mesh.triangles.push_back({0, 1, 8});
  EXPECT_EQ(healthOf(mesh).degenerateTriangles, 1);
}

TEST(MeshHealth, selfIntersectionsAreFoundAndTouchingIsNot) {
  TriMesh two = shapes::box(Vec3::Zero(), Vec3::Ones());
  EXPECT_EQ(countSelfIntersections(two), 0);
  const auto with = [&](const Vec3& low, const Vec3& high) {
    TriMesh mesh = two;
    const TriMesh other = shapes::box(low, high);
    for (auto t : other.triangles) mesh.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
    mesh.vertices.insert(mesh.vertices.end(), other.vertices.begin(), other.vertices.end());
    return countSelfIntersections(mesh);
  };
  EXPECT_EQ(with(Vec3::Constant(1.1), Vec3::Constant(2)), 0);
  EXPECT_EQ(with(Vec3(1, 0.2, 0.3), Vec3(2, 0.8, 0.9)), 0) << "one face lies on the other";
  EXPECT_GT(with(Vec3(0.9, 0.2, 0.3), Vec3(2, 0.8, 0.9)), 0);
  EXPECT_EQ(with(Vec3::Constant(0.1), Vec3::Constant(0.9)), 0) << "inside without touching";
  EXPECT_EQ(countSelfIntersections(shapes::torus(0.02, 0.004, 40, 12)), 0);
  TriMesh pierced = shapes::sphere(0.02);
  pierced.vertices[0] = Vec3(0.001, 0.03, 0.002);  // the lower pole pulled out through the top
  EXPECT_GT(countSelfIntersections(pierced), 0);
}
