// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/embed/CageWeights.h"

#include <gtest/gtest.h>

#include <random>

#include "simcore/embed/MeanValue.h"
#include "tests/simcore/mesh/Shapes.h"

namespace glenoid {
namespace {

std::vector<Vec3> inside(const Box3& box, int count) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0.05, 0.95);
  std::vector<Vec3> points;
  for (int i = 0; i < count; ++i)
    points.push_back(box.min() + Vec3(unit(random), unit(random), unit(random)).cwiseProduct(box.sizes()));
  return points;
}

Vec3 mean(const TriMesh& mesh, const VecX& weights) {
  Vec3 sum = Vec3::Zero();
  for (std::size_t v = 0; v < mesh.vertices.size(); ++v) sum += weights[static_cast<Eigen::Index>(v)] * mesh.vertices[v];
  return sum;
}

/// A horseshoe: two arms along x, 0.1 long and 0.02 thick, 4 mm apart, joined at x = 0.
TriMesh horseshoe() {
  TriMesh mesh;
  const double L = 0.1, w = 0.02, gap = 0.004;
  const std::vector<std::pair<double, double>> outline{{0, 0}, {L, 0}, {L, w}, {w, w}, {w, w + gap}, {L, w + gap}, {L, 2 * w + gap}, {0, 2 * w + gap}};
  for (const double y : {0.0, w})
    for (const auto& [x, z] : outline) mesh.vertices.push_back({x, y, z});
  for (const auto& t : std::vector<std::array<int, 3>>{{0, 1, 2}, {0, 2, 3}, {0, 3, 4}, {0, 4, 7}, {4, 5, 6}, {4, 6, 7}}) {
    mesh.triangles.push_back(t);
    mesh.triangles.push_back({t[0] + 8, t[2] + 8, t[1] + 8});
  }
  for (int i = 0; i < 8; ++i) {
    const int j = (i + 1) % 8;
    mesh.triangles.push_back({i, i + 8, j});
    mesh.triangles.push_back({j, i + 8, j + 8});
  }
  return mesh;
}

TEST(MeanValue, linearFieldsAreReproducedInsideOutsideAndBesideFaces) {
  const TriMesh cage = shapes::sphere(0.05, 10, 7);
  std::vector<Vec3> points = inside(Box3(Vec3::Constant(-0.09), Vec3::Constant(0.09)), 300);
  // In the plane of a face but not in it, on an edge's line, and hard at a face.
  const auto& t = cage.triangles[20];
  const Vec3 &a = cage.vertices[t[0]], &b = cage.vertices[t[1]], &c = cage.vertices[t[2]];
  points.push_back(2 * a - 0.5 * b - 0.5 * c);
  points.push_back(2 * b - a);
  points.push_back((a + b + c) / 3 * (1 - 1e-7));
  for (const Vec3& p : points) {
    const VecX weights = meanValueCoordinates(cage, p);
    EXPECT_NEAR(weights.sum(), 1, 1e-12);
    // Near a face's plane the weights are quotients of small sines: a millionth of the cage's size.
    EXPECT_LT((mean(cage, weights) - p).norm(), 1e-7) << p.transpose();
  }
}

TEST(MeanValue, onTheSurfaceTheyAreBarycentric) {
  const TriMesh cage = shapes::box(Vec3(-1, -2, -3), Vec3(2, 3, 4));
  for (const auto& t : cage.triangles) {
    const Vec3 w(0.2, 0.5, 0.3);
    const VecX weights = meanValueCoordinates(cage, w[0] * cage.vertices[t[0]] + w[1] * cage.vertices[t[1]] + w[2] * cage.vertices[t[2]]);
    for (int k = 0; k < 3; ++k) EXPECT_NEAR(weights[t[k]], w[k], 1e-9);
  }
  for (std::size_t v = 0; v < cage.vertices.size(); ++v)
    EXPECT_EQ(meanValueCoordinates(cage, cage.vertices[v])[static_cast<Eigen::Index>(v)], 1);
}

TEST(MeanValue, theyAreContinuousThroughAFace) {
  const TriMesh cage = shapes::sphere(0.05, 10, 7);
  const auto& t = cage.triangles[33];
  const Vec3 on = 0.5 * cage.vertices[t[0]] + 0.2 * cage.vertices[t[1]] + 0.3 * cage.vertices[t[2]];
  const VecX at = meanValueCoordinates(cage, on);
  for (const double off : {-1e-6, 1e-6})
    EXPECT_LT((meanValueCoordinates(cage, on * (1 + off)) - at).norm(), 2e-4) << off;
}

TEST(CageWeights, aConvexCageNeedsNoOtherKind) {
  const TriMesh cage = shapes::sphere(0.05, 10, 7);
  std::vector<Vec3> points = inside(Box3(Vec3::Constant(-0.025), Vec3::Constant(0.025)), 50);
  const auto weights = cageWeights(cage, points);
  ASSERT_TRUE(weights.ok());
  EXPECT_EQ(weights->kind, CageCoordinates::MeanValue);
  EXPECT_GT(weights->weights.minCoeff(), -1e-12);
}

TEST(CageWeights, whereMeanValueTurnsNegativeHarmonicOnesStayPositive) {
  const TriMesh cage = horseshoe();
  const std::vector<Vec3> points{{0.09, 0.01, 0.016}, {0.05, 0.012, 0.008}, {0.01, 0.01, 0.022}, {0.09, 0.01, 0.03}};
  const auto otherArm = [](const auto& row) { return std::abs(row(5)) + std::abs(row(6)) + std::abs(row(13)) + std::abs(row(14)); };
  const VecX meanValue = meanValueCoordinates(cage, points[0]);
  EXPECT_LT(meanValue.minCoeff(), -0.05);  // the case is a hard one
  EXPECT_GT(otherArm(meanValue), 0.1);
  const auto weights = cageWeights(cage, points);
  ASSERT_TRUE(weights.ok());
  EXPECT_EQ(weights->kind, CageCoordinates::Harmonic);
  EXPECT_GE(weights->weights.minCoeff(), 0);
  for (Eigen::Index i = 0; i < weights->weights.rows(); ++i) EXPECT_NEAR(weights->weights.row(i).sum(), 1, 1e-12);
  // Handles at the end of one arm have nothing to say at the end of the other.
  EXPECT_LT(otherArm(weights->weights.row(0)), 1e-3);
}

TEST(CageWeights, harmonicOnesReproduceLinearFieldsAsFarAsTheirCellsCan) {
  const TriMesh cage = shapes::box(Vec3::Constant(-0.05), Vec3::Constant(0.05));
  const std::vector<Vec3> points = inside(Box3(Vec3::Constant(-0.05), Vec3::Constant(0.05)), 60);
  const auto weights = harmonicCoordinates(cage, points);
  ASSERT_TRUE(weights.ok());
  // Nodes up to a cell (7 mm) outside take the value of the nearest point of the cage.
  for (std::size_t i = 0; i < points.size(); ++i)
    EXPECT_LT((mean(cage, weights->row(static_cast<Eigen::Index>(i)).transpose()) - points[i]).norm(), 4e-3);
}

TEST(CageWeights, pointsFollowTheirCage) {
  const TriMesh cage = shapes::sphere(0.05, 10, 7);
  const std::vector<Vec3> points = inside(Box3(Vec3::Constant(-0.025), Vec3::Constant(0.025)), 20);
  const auto weights = cageWeights(cage, points);
  ASSERT_TRUE(weights.ok());
  EXPECT_EQ(followCage(*weights, points, cage.vertices, cage.vertices), points);
  Mat3 map;
  map << 1.1, 0.2, 0, -0.1, 0.9, 0.05, 0.3, 0, 1.2;
  std::vector<Vec3> moved;
  for (const Vec3& v : cage.vertices) moved.push_back(map * v + Vec3(1, 2, 3));
  const std::vector<Vec3> at = followCage(*weights, points, cage.vertices, moved);
  for (std::size_t i = 0; i < points.size(); ++i) EXPECT_LT((at[i] - (map * points[i] + Vec3(1, 2, 3))).norm(), 1e-9);
}

TEST(CageWeights, anOpenCageIsRefused) {
  TriMesh cage = shapes::sphere(0.05, 10, 7);
  cage.triangles.pop_back();
  const auto weights = cageWeights(cage, std::vector<Vec3>{Vec3::Zero()});
  ASSERT_FALSE(weights.ok());
  EXPECT_EQ(weights.error().fault, Fault::MeshNotClosed);
}

}  // namespace
}  // namespace glenoid
