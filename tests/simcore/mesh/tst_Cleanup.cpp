// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/mesh/Cleanup.h"

#include <gtest/gtest.h>

#include "simcore/mesh/MeshHealth.h"
#include "tests/simcore/mesh/Shapes.h"

using namespace glenoid;

namespace {

/// Every triangle with corners of its own, as STL stores them.
TriMesh soup(const TriMesh& mesh, double jitter) {
  TriMesh out;
  int k = 0;
  for (const auto& t : mesh.triangles) {
    for (const int i : t) {
      out.vertices.push_back(mesh.vertices[i] + jitter * Vec3(std::sin(k), std::cos(3 * k), std::sin(7 * k)));
      ++k;
    }
    out.triangles.push_back({k - 3, k - 2, k - 1});
  }
  return out;
}

}  // namespace

TEST(Cleanup, weldingASoupGivesTheClosedSurfaceBack) {
  const TriMesh ball = shapes::sphere(0.02);
  const TriMesh loose = soup(ball, 1e-9);
  EXPECT_EQ(healthOf(loose).openEdges, 3 * static_cast<int>(ball.triangles.size()));
  const TriMesh welded = weldVertices(loose, 1e-8);
  EXPECT_EQ(welded.vertices.size(), ball.vertices.size());
  EXPECT_TRUE(healthOf(welded).healthy());
}

TEST(Cleanup, weldingDropsFlatAndDoubleTriangles) {
  TriMesh mesh = soup(shapes::box(Vec3::Zero(), Vec3::Ones()), 0);
  mesh.triangles.push_back({1, 2, 0});  // the first one again, turned on
  mesh.vertices.push_back(Vec3(0, 0, 1e-7));
  mesh.triangles.push_back({0, static_cast<int>(mesh.vertices.size()) - 1, 2});  // thinner than the tolerance
  const TriMesh welded = weldVertices(mesh, 1e-6);
  EXPECT_EQ(welded.vertices.size(), 8u);
  EXPECT_EQ(welded.triangles.size(), 12u);
  EXPECT_TRUE(healthOf(welded).healthy());
}

TEST(Cleanup, compactRenumbersInOrder) {
  TriMesh mesh;
  for (int i = 0; i < 6; ++i) mesh.vertices.push_back(Vec3(i, i * i, 0));
  mesh.triangles = {{5, 1, 3}, {2, 2, 4}};
  const TriMesh out = compact(mesh);
  ASSERT_EQ(out.vertices.size(), 3u);
  EXPECT_EQ(out.vertices[0], mesh.vertices[1]);
  EXPECT_EQ(out.vertices[2], mesh.vertices[5]);
  ASSERT_EQ(out.triangles.size(), 1u);
  EXPECT_EQ(out.triangles[0], (std::array<int, 3>{2, 0, 1}));
}
