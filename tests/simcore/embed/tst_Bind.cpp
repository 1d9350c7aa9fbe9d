// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/embed/Bind.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "simcore/embed/Cells.h"
#include "simcore/spatial/TriangleTree.h"
#include "tests/simcore/mesh/Shapes.h"

using namespace glenoid;

TEST(Bind, restPositionsAndLinearFieldsAreReproduced) {
  const TriMesh ball = shapes::sphere(0.02);
  const TetMesh mesh = embedInCells(ball, ball, 0.011).value();
  std::vector<Vec3> points = ball.vertices;
  points.push_back(Vec3(0.05, -0.01, 0.02));  // far outside: extrapolated, linear all the same
  const std::vector<VertexBinding> bindings = bindToTets(mesh, points);
  ASSERT_EQ(bindings.size(), points.size());
  Mat3 A;
  A << 1.1, 0.2, -0.3, 0.05, 0.9, 0.4, -0.2, 0.1, 1.3;
  const Vec3 b(0.3, -0.2, 0.1);
  std::vector<Vec3> bent;
  for (const Vec3& x : mesh.nodes) bent.push_back(A * x + b);
  for (std::size_t i = 0; i < points.size(); ++i) {
    double sum = 0;
    for (const double w : bindings[i].weight) sum += w;
    EXPECT_NEAR(sum, 1, 1e-14);
    // Scaled by the part's and the offset's size; round-off of four products.
    EXPECT_LT((boundPosition(bindings[i], mesh.nodes) - points[i]).norm(), 1e-12 * 0.02);
    EXPECT_LT((boundPosition(bindings[i], bent) - (A * points[i] + b)).norm(), 1e-12 * 0.3);
  }
  for (std::size_t i = 0; i < ball.vertices.size(); ++i)
    for (const double w : bindings[i].weight) {
      EXPECT_GE(w, -1e-12);
      EXPECT_LE(w, 1 + 1e-12);
    }
}

TEST(Bind, nodesBindToThemselvesAndOutsidersToTheNearest) {
  TetMesh mesh{{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ(), Vec3(1, 1, 1)},
               {{0, 1, 2, 3}, {1, 2, 3, 4}}};
  const std::vector<Vec3> points{Vec3::Zero(), Vec3(-0.1, 0.2, 0.2), Vec3(1.05, 1.02, 1.01)};
  EXPECT_EQ(tetsOf(mesh, points), (std::vector<int>{0, 0, 1}));
  EXPECT_EQ(bindToTets(mesh, points)[0].weight, (std::array<double, 4>{1, 0, 0, 0}));
  EXPECT_LT(bindToTets(mesh, points)[1].weight[1], 0);
}

// By looking at every tetrahedron, and outside at every face: the answer for many points, which a tree gives, and for one alone.
TEST(Bind, manyPointsAndOneGoWhereALookAtAllSays) {
  const TriMesh ball = shapes::sphere(0.02);
  const TetMesh mesh = embedInCells(ball, ball, 0.007).value();
  TriMesh faces;
  faces.vertices = mesh.nodes;
  for (const auto& t : mesh.tets)
    for (const std::array<int, 3> f : {std::array{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}}) faces.triangles.push_back({t[f[0]], t[f[1]], t[f[2]]});
  const TriangleTree tree(faces);
  std::vector<Vec3> points;
  for (int i = 0; i < 300; ++i) points.push_back(0.03 * Vec3(std::sin(1.3 * i), std::sin(2.1 * i + 1), std::sin(3.7 * i + 2)));
  for (std::size_t n = 0; n < mesh.nodes.size(); n += 5) points.push_back(mesh.nodes[n]);  // on many tetrahedra at once
  for (std::size_t t = 0; t < mesh.tets.size(); t += 7) points.push_back((mesh.nodes[mesh.tets[t][0]] + mesh.nodes[mesh.tets[t][1]]) / 2);
  const std::vector<int> together = tetsOf(mesh, points);
  int outside = 0;
  for (std::size_t i = 0; i < points.size(); ++i) {
    int expected = -1;
    double most = -1e-12;
    for (int t = 0; t < static_cast<int>(mesh.tets.size()); ++t) {
      const auto w = barycentricOf(mesh, t, points[i]);
      const double least = *std::min_element(w.begin(), w.end());
      if (least > most || (expected < 0 && least >= -1e-12)) expected = t, most = least;
    }
    outside += expected < 0;
    if (expected < 0) expected = tree.closest(points[i]).triangle / 4;
    EXPECT_EQ(together[i], expected) << i;
    EXPECT_EQ(tetsOf(mesh, std::span(&points[i], 1))[0], expected) << i;
  }
  EXPECT_GT(outside, 50);
  EXPECT_LT(outside, static_cast<int>(points.size()) - 50);
}

TEST(Bind, rigidPointsKeepTheirArm) {
  const std::vector<Vec3> points{Vec3(1, 2, 3), Vec3(0, 0, 0)};
  const auto bindings = bindToRigid(points, Vec3(0.5, 0.5, 0.5));
  EXPECT_EQ(bindings[0].r_B, Vec3(0.5, 1.5, 2.5));
  EXPECT_EQ(bindings[1].r_B, Vec3(-0.5, -0.5, -0.5));
}

TEST(Bind, labelsComeFromTheNearestTriangle) {
  const TriMesh ball = shapes::sphere(0.02);
  const TetMesh mesh = embedInCells(ball, ball, 0.008).value();
  std::vector<int> labels;
  for (const auto& t : ball.triangles)
    labels.push_back((ball.vertices[t[0]] + ball.vertices[t[1]] + ball.vertices[t[2]]).y() > 0 ? 7 : 3);
  const std::vector<int> found = labelTets(mesh, ball, labels);
  ASSERT_EQ(found.size(), mesh.tets.size());
  int clear = 0;
  for (std::size_t t = 0; t < found.size(); ++t) {
    Vec3 centroid = Vec3::Zero();
    for (const int v : mesh.tets[t]) centroid += mesh.nodes[v] / 4;
    if (std::abs(centroid.y()) < 0.002) continue;  // nearer to the seam than a facet's size
    ++clear;
    EXPECT_EQ(found[t], centroid.y() > 0 ? 7 : 3);
  }
  EXPECT_GT(clear, static_cast<int>(found.size()) / 2);
  EXPECT_EQ(labelTets(mesh, TriMesh{}, {}), std::vector<int>(mesh.tets.size(), -1));
}
