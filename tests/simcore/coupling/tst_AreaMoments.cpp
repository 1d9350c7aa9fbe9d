// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/coupling/AreaMoments.h"

#include <gtest/gtest.h>

#include <numeric>
#include <random>

#include "tests/simcore/coupling/Integrals.h"

namespace glenoid {
namespace {

/// Triangles anywhere in a ball of the size, needles among them.
TriMesh scattered(int count, double size, const Vec3& at, unsigned seed) {
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-size, size);
  TriMesh mesh;
  for (int t = 0; t < count; ++t) {
    const Vec3 middle = at + Vec3(uniform(random), uniform(random), uniform(random));
    for (int i = 0; i < 3; ++i) {
      const double reach = t % 5 ? 0.3 : 3e-4;
      mesh.vertices.push_back(middle + reach * Vec3(uniform(random), uniform(random), uniform(random)));
    }
    mesh.triangles.push_back({3 * t, 3 * t + 1, 3 * t + 2});
  }
  return mesh;
}

std::vector<Triangle> listed(const TriMesh& mesh) {
  std::vector<Triangle> triangles;
  for (const auto& t : mesh.triangles) triangles.push_back({mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]});
  return triangles;
}

std::vector<int> all(const TriMesh& mesh) {
  std::vector<int> indices(mesh.triangles.size());
  std::iota(indices.begin(), indices.end(), 0);
  return indices;
}

TEST(AreaMoments, ofARectangleAreThoseOfTheBook) {
  const double a = 0.03, b = 0.02;
  const std::vector<Triangle> halves{{Vec3(0, 0, 5), Vec3(a, 0, 5), Vec3(a, b, 5)}, {Vec3(0, 0, 5), Vec3(a, b, 5), Vec3(0, b, 5)}};
  const AreaMoments moments = momentsOf(halves);
  // Round-off of centimetres at five metres: 1e-15 m beside 1e-2 m.
  EXPECT_NEAR(moments.area, a * b, 1e-13 * a * b);
  EXPECT_LT((moments.centre - Vec3(a / 2, b / 2, 5)).norm(), 1e-15);
  EXPECT_NEAR(moments.second(0, 0), a * a * a * b / 12, 1e-12 * a * a * a * b);
  EXPECT_NEAR(moments.second(1, 1), a * b * b * b / 12, 1e-12 * a * a * a * b);
  EXPECT_LT(std::abs(moments.second(0, 1)) + moments.second.col(2).norm(), 1e-12 * a * a * a * b);
  EXPECT_NEAR(radiiOfGyration(moments)(2), a / std::sqrt(12.0), 1e-14);
  EXPECT_NEAR(radiiOfGyration(moments)(1), b / std::sqrt(12.0), 1e-14);
}

TEST(AreaMoments, ofAnySurfaceAreItsIntegrals) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    const TriMesh mesh = scattered(60, 0.02, Vec3(0.1, -0.4, 0.2), seed);
    const AreaMoments moments = momentsOf(listed(mesh));
    const test::SurfaceIntegral exact = test::integrated(mesh, all(mesh));
    // The reference sums in coordinates of 0.5 m: that costs it two digits of sixteen.
    EXPECT_NEAR(moments.area, exact.area, 1e-13 * exact.area);
    EXPECT_LT((moments.centre - exact.centre).norm(), 1e-14);
    EXPECT_LT((moments.second - exact.second).norm(), 1e-12 * exact.second.norm());
  }
}

TEST(AreaMoments, fourPointsCarryThem) {
  std::vector<TriMesh> surfaces{scattered(1, 0.02, Vec3::Zero(), 5), scattered(40, 0.02, Vec3(1, 2, 3), 6)};
  surfaces.push_back(scattered(3, 0.02, Vec3::Zero(), 7));
  for (Vec3& v : surfaces.back().vertices) v.x() = 0.01;  // plane across the first axis: the first pivot is nothing
  for (const TriMesh& mesh : surfaces) {
    const AreaMoments moments = momentsOf(listed(mesh));
    const auto points = pointsWithMoments(moments);
    Vec3 mean = Vec3::Zero();
    for (const Vec3& p : points) mean += p / 4;
    Mat3 spread = Mat3::Zero();
    for (const Vec3& p : points) spread += (p - moments.centre) * (p - moments.centre).transpose() / 4;
    EXPECT_LT((mean - moments.centre).norm(), 1e-15);
    // A pivot below 1e-14 of the trace is taken for none; what it carried off the diagonal is its square root at most.
    EXPECT_LT((moments.area * spread - moments.second).norm(), 1e-6 * moments.second.norm());
  }
}

TEST(AreaMoments, fourPointsOfATriangleLieInItsPlaneAndInside) {
  for (unsigned seed = 1; seed < 20; ++seed) {
    const Triangle t = listed(scattered(2, 0.02, Vec3::Zero(), seed))[1];
    const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
    for (const Vec3& p : pointsWithMoments(momentsOf({{t}}))) {
      // In the plane as far as a pivot of round-off (1e-14 of the square) lets it: its root, of 6 mm.
      EXPECT_LT(std::abs(normal.normalized().dot(p - t[0])), 1e-8);
      for (int i = 0; i < 3; ++i)
        EXPECT_GT(normal.dot((t[(i + 1) % 3] - t[i]).cross(p - t[i])) / normal.squaredNorm(), -1e-9);
    }
  }
}

TEST(AreaMoments, cuttingKeepsThem) {
  const TriMesh mesh = scattered(50, 0.02, Vec3::Zero(), 9);
  const AreaMoments whole = momentsOf(listed(mesh));
  for (int axis = 0; axis < 3; ++axis)
    for (const double at : {-0.5, whole.centre[axis], mesh.vertices[4][axis]}) {
      const auto sides = cutAt(listed(mesh), axis, at);
      std::vector<Triangle> both = sides[0];
      both.insert(both.end(), sides[1].begin(), sides[1].end());
      const AreaMoments moments = momentsOf(both);
      EXPECT_NEAR(moments.area, whole.area, 1e-13 * whole.area);
      EXPECT_LT((moments.centre - whole.centre).norm(), 1e-15);
      EXPECT_LT((moments.second - whole.second).norm(), 1e-13 * whole.second.norm());
      for (const int side : {0, 1})
        for (const Triangle& t : sides[side])
          for (const Vec3& p : t) EXPECT_TRUE(side ? p[axis] > at - 1e-15 : p[axis] < at + 1e-15);
    }
}

TEST(AreaMoments, nothingHasNone) {
  EXPECT_EQ(momentsOf(std::span<const Triangle>{}).area, 0);
  const Triangle line{Vec3(0, 0, 0), Vec3(1, 1, 1), Vec3(2, 2, 2)};
  EXPECT_EQ(momentsOf({{line}}).area, 0);
  EXPECT_EQ(radiiOfGyration(momentsOf({{line}})), Vec3(0, 0, 0));
}

}  // namespace
}  // namespace glenoid
