// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "simcore/spatial/TriangleTree.h"
#include "tests/simcore/spatial/Shapes.h"

namespace glenoid {
namespace {

using namespace shapes;

std::vector<TriMesh> meshes() {
  const Pose tilt = poseOf({0.01, -0.02, 0.03}, {1, 2, 3}, 0.7);
  return {sphere({0.1, 0, 0}, 0.8, 3), moved(box({-1, -0.4, -0.2}, {0.7, 0.5, 0.3}), tilt),
          torus(0.7, 0.25, 31, 17), moved(torus(0.6, 0.2, 12, 9), tilt)};
}

/// Nearest point of a triangle by minimising over its plane and its edges separately: no Voronoi regions.
double slowDistance(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  double best = std::numeric_limits<double>::infinity();
  for (const auto& [s, e] : {std::pair(a, b), std::pair(b, c), std::pair(c, a)}) {
    const double t = std::clamp((p - s).dot(e - s) / (e - s).squaredNorm(), 0.0, 1.0);
    best = std::min(best, (s + t * (e - s) - p).norm());
  }
  const Vec3 n = (b - a).cross(c - a).normalized();
  const Vec3 q = p - n * n.dot(p - a);
  const bool within = n.dot((b - a).cross(q - a)) >= 0 && n.dot((c - b).cross(q - b)) >= 0 &&
                      n.dot((a - c).cross(q - c)) >= 0;
  return within ? std::min(best, std::abs(n.dot(p - a))) : best;
}

/// Winding number by the solid angles of all triangles. Source: Van Oosterom and Strackee 1983.
double winding(const TriMesh& mesh, const Vec3& p) {
  double sum = 0;
  for (const auto& t : mesh.triangles) {
    const Vec3 a = mesh.vertices[t[0]] - p, b = mesh.vertices[t[1]] - p, c = mesh.vertices[t[2]] - p;
    const double la = a.norm(), lb = b.norm(), lc = c.norm();
    sum += 2 * std::atan2(a.dot(b.cross(c)), la * lb * lc + a.dot(b) * lc + b.dot(c) * la + c.dot(a) * lb);
  }
  return sum / (4 * std::numbers::pi);
}

TEST(TriangleTree, closestEqualsBruteForce) {
  Numbers numbers(1);
  for (const TriMesh& mesh : meshes()) {
    const TriangleTree tree(mesh);
    for (int i = 0; i < 400; ++i) {
      const Vec3 p = numbers.point(1.3);
      double slow = std::numeric_limits<double>::infinity();
      for (const auto& t : mesh.triangles) {
        slow = std::min(slow, slowDistance(p, mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]));
      }
      const TriangleTree::Closest found = tree.closest(p);
      EXPECT_NEAR(found.distance, slow, 1e-13);  // round-off of coordinates near 1
      ASSERT_GE(found.triangle, 0);
      const auto& t = mesh.triangles[found.triangle];
      const Vec3 x = found.barycentric[0] * mesh.vertices[t[0]] + found.barycentric[1] * mesh.vertices[t[1]] +
                     found.barycentric[2] * mesh.vertices[t[2]];
      EXPECT_LT((x - found.point).norm(), 1e-14);
      EXPECT_NEAR((found.point - p).norm(), found.distance, 1e-14);
      EXPECT_GE(found.barycentric.minCoeff(), 0);
      EXPECT_NEAR(found.barycentric.sum(), 1, 1e-14);
      EXPECT_EQ(tree.closest(p, 0.99 * slow).triangle, -1);
    }
  }
}

TEST(TriangleTree, insideAgreesWithTheWindingNumber) {
  Numbers numbers(2);
  int inside = 0, outside = 0;
  for (const TriMesh& mesh : meshes()) {
    const TriangleTree tree(mesh);
    for (int i = 0; i < 400; ++i) {
      const Vec3 p = numbers.point(1.0);
      const bool slow = winding(mesh, p) > 0.5;
      (slow ? inside : outside) += 1;
      EXPECT_EQ(tree.inside(p), slow);
      EXPECT_EQ(tree.signedDistance(p) < 0, slow);
    }
  }
  EXPECT_GT(inside, 100);
  EXPECT_GT(outside, 100);
}

TEST(TriangleTree, raysThroughEdgesAndVerticesCountOnce) {
  // The axis rays from these points run exactly through vertices, along edges and along face diagonals.
  const TriangleTree cube(box({-1, -1, -1}, {1, 1, 1}));
  for (const double x : {-2.0, -1.5, -0.5, 0.0, 0.5, 1.5}) {
    for (const double y : {-1.5, -1.0, -0.5, 0.0, 0.5, 1.0, 1.5}) {
      for (const double z : {-1.5, -1.0, 0.0, 0.5, 1.0, 1.5}) {
        const Vec3 p(x, y, z);
        if (p.cwiseAbs().maxCoeff() == 1.0) continue;  // on the surface
        EXPECT_EQ(cube.inside(p), p.cwiseAbs().maxCoeff() < 1.0) << p.transpose();
      }
    }
  }
  const TriangleTree ball(sphere({0, 0, 0}, 1, 3));  // many vertices share coordinates
  for (const Vec3& v : ball.mesh().vertices) {
    for (const double scale : {0.5, 0.99, 1.01, 2.0}) EXPECT_EQ(ball.inside(scale * v), scale < 1);
  }
}

TEST(TriangleTree, signedDistanceOfABoxIsKnown) {
  const TriangleTree tree(box({-1, -2, -3}, {1, 2, 3}));
  EXPECT_NEAR(tree.signedDistance({0.75, 0.3, -0.1}), -0.25, 1e-15);
  EXPECT_NEAR(tree.signedDistance({4, 6, 0}), 5, 1e-15);
  EXPECT_NEAR(tree.signedDistance({2, 3, 5}), std::sqrt(1.0 + 1.0 + 4.0), 1e-15);
}

TEST(TriangleTree, castEqualsBruteForceAndRespectsTheLimit) {
  Numbers numbers(3);
  int hits = 0;
  for (const TriMesh& mesh : meshes()) {
    const TriangleTree tree(mesh);
    for (int i = 0; i < 300; ++i) {
      const Vec3 origin = numbers.point(1.5), direction = numbers.point(0.8) - origin;
      // Plane by plane, with inside decided by areas: another way to the same point.
      double slow = std::numeric_limits<double>::infinity();
      for (const auto& t : mesh.triangles) {
        const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
        const Vec3 n = (b - a).cross(c - a);
        const double s = n.dot(a - origin) / n.dot(direction.normalized());
        const Vec3 x = origin + s * direction.normalized();
        const double area =
            (b - x).cross(c - x).norm() + (c - x).cross(a - x).norm() + (a - x).cross(b - x).norm();
        if (s >= 0 && area <= n.norm() * (1 + 1e-9)) slow = std::min(slow, s);
      }
      const auto hit = tree.cast(origin, 3 * direction);
      ASSERT_EQ(hit.has_value(), std::isfinite(slow));
      if (!hit) continue;
      ++hits;
      EXPECT_NEAR(hit->distance, slow, 1e-9);  // rays that graze a triangle lose digits
      EXPECT_LT((hit->point - origin - hit->distance * direction.normalized()).norm(), 1e-14);
      EXPECT_FALSE(tree.cast(origin, direction, 0.999 * slow).has_value());
    }
  }
  EXPECT_GT(hits, 200);
  const TriangleTree cube(box({-1, -1, -1}, {1, 1, 1}));
  EXPECT_FALSE(cube.cast({0, 0, 0}, {0, 0, 0}).has_value());
  EXPECT_LT((cube.cast({0.2, 0.1, 5}, {0, 0, -1})->normal - Vec3(0, 0, 1)).norm(), 1e-15);
}

TEST(TriangleTree, overlappingEqualsBruteForce) {
  Numbers numbers(4);
  for (const TriMesh& mesh : meshes()) {
    const TriangleTree tree(mesh);
    std::vector<int> found;
    for (int i = 0; i < 100; ++i) {
      Box3 region;
      region.extend(numbers.point(1)).extend(numbers.point(1));
      std::vector<int> slow;
      for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t) {
        Box3 own;
        for (const int v : mesh.triangles[t]) own.extend(mesh.vertices[v]);
        if (own.intersects(region)) slow.push_back(t);
      }
      tree.overlapping(region, found);
      EXPECT_EQ(found, slow);
    }
  }
}

TEST(TriangleTree, survivesEmptyAndFlatMeshes) {
  const TriangleTree none{TriMesh{}};
  EXPECT_EQ(none.closest({0, 0, 0}).triangle, -1);
  EXPECT_FALSE(none.inside({0, 0, 0}));
  EXPECT_FALSE(none.cast({0, 0, 0}, {1, 0, 0}).has_value());
  const TriangleTree flat{TriMesh{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {1, 1, 1}}, {{0, 1, 2}, {3, 3, 3}}}};
  EXPECT_NEAR(flat.closest({0.5, 1, 0}).distance, 1.0, 1e-15);
  EXPECT_NEAR(flat.closest({1, 1, 2}).distance, 1.0, 1e-15);
  EXPECT_FALSE(flat.inside({0.5, 0, 0}));
}

}  // namespace
}  // namespace glenoid
