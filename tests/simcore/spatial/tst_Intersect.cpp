// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "simcore/spatial/Intersect.h"
#include "tests/simcore/spatial/Shapes.h"

namespace glenoid {
namespace {

using namespace shapes;
using Triangle = std::array<Vec3, 3>;

const Triangle kFlat{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)};

/// The same answer whichever is first and however the corners are turned.
bool meet(const Triangle& a, const Triangle& b) {
  const bool first = trianglesMeet(a, b);
  EXPECT_EQ(trianglesMeet(b, a), first);
  EXPECT_EQ(trianglesMeet({a[1], a[2], a[0]}, {b[2], b[1], b[0]}), first);
  return first;
}

TEST(Intersect, orientationHasTheSignOfTheVolume) {
  EXPECT_EQ(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}), 1);
  EXPECT_EQ(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, -1}), -1);
  EXPECT_EQ(orient3d({0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {5, -7, 0}), 0);
  EXPECT_EQ(orient2d({0, 0}, {1, 0}, {0, 1}), 1);
  EXPECT_EQ(orient2d({0, 0}, {0, 1}, {1, 0}), -1);
}

TEST(Intersect, orientationIsExactWhereDoublesAreNot) {
  // Points of a plane x + y + z = 1 whose coordinates are multiples of 2⁻⁵⁰, so that coplanarity is exact;
  // then one coordinate moves by the smallest step. Plain doubles get many of these wrong.
  Numbers numbers(5);
  constexpr double step = 0x1p-50;
  int plainWrong = 0;
  for (int i = 0; i < 500; ++i) {
    const auto onPlane = [&] {
      const double x = std::round(numbers.in(0, 0.5) / step) * step,
                   y = std::round(numbers.in(0, 0.5) / step) * step;
      return Vec3(x, y, 1 - x - y);
    };
    const Vec3 a = onPlane(), b = onPlane(), c = onPlane(), d = onPlane();
    const double turn = (b - a).cross(c - a).sum();  // along (1, 1, 1)
    if (std::abs(turn) < 1e-6) continue;
    const int side = turn > 0 ? 1 : -1;
    EXPECT_EQ(orient3d(a, b, c, d), 0);
    EXPECT_EQ(orient3d(a, b, c, d + Vec3(0, 0, step)), side);
    EXPECT_EQ(orient3d(a, b, c, d - Vec3(0, step, 0)), -side);
    EXPECT_EQ(orient3d(b, a, c, d + Vec3(0, 0, step)), -side);
    EXPECT_EQ(orient3d(d + Vec3(0, 0, step), a, b, c), -side);
    plainWrong += (b - a).cross(c - a).dot(d - a) != 0;
  }
  EXPECT_GT(plainWrong, 50);  // otherwise this test would prove nothing
  for (int i = 0; i < 500; ++i) {
    // c = a + k (b − a) with a power of two and short numbers: exactly on the line.
    const Vec2 a(std::round(numbers.in(1, 2) * 0x1p40) * 0x1p-40,
                 std::round(numbers.in(1, 2) * 0x1p40) * 0x1p-40);
    const Vec2 b = a + Vec2(std::round(numbers.in(1, 2) * 0x1p10) * 0x1p-40, 0x1p-38);
    const Vec2 c = a + 4 * (b - a);
    EXPECT_EQ(orient2d(a, b, c), 0);
    EXPECT_EQ(orient2d(a, b, c + Vec2(0, 0x1p-50)), 1);
    EXPECT_EQ(orient2d(a, b, c + Vec2(0x1p-50, 0)), -1);
  }
}

TEST(Intersect, crossingTrianglesMeet) {
  EXPECT_TRUE(meet(kFlat, {Vec3(0.2, 0.2, -1), Vec3(0.3, 0.2, 1), Vec3(0.2, 0.3, 1)}));  // through the middle
  EXPECT_TRUE(meet(kFlat, {Vec3(-1, 0.2, -1), Vec3(3, 0.2, -1), Vec3(0.2, 0.2, 1)}));    // all the way across
  EXPECT_FALSE(meet(kFlat, {Vec3(2, 2, -1), Vec3(2.1, 2, 1), Vec3(2, 2.1, 1)}));  // planes cross elsewhere
  EXPECT_FALSE(meet(kFlat, {Vec3(0.2, 0.2, 0.1), Vec3(0.3, 0.2, 1), Vec3(0.2, 0.3, 1)}));  // above
}

TEST(Intersect, touchingCountsToTheLastBit) {
  const Triangle cornerInFace{Vec3(0.25, 0.25, 0), Vec3(0.3, 0.2, 1), Vec3(0.2, 0.3, 1)};
  EXPECT_TRUE(meet(kFlat, cornerInFace));
  EXPECT_FALSE(meet(kFlat, {Vec3(0.25, 0.25, 0x1p-60), cornerInFace[1], cornerInFace[2]}));
  EXPECT_TRUE(meet(kFlat, {Vec3(0, 0, 0), Vec3(-1, -1, 1), Vec3(-1, -1, -1)}));      // corner at corner
  EXPECT_TRUE(meet(kFlat, {Vec3(0.5, 0, 0), Vec3(0.5, -1, 1), Vec3(0.5, -1, -1)}));  // corner on edge
  EXPECT_TRUE(meet(kFlat, {Vec3(0.5, 0.5, -1), Vec3(0.5, 0.5, 1), Vec3(2, 2, 0)}));  // edge crosses edge
  EXPECT_FALSE(meet(kFlat, {Vec3(0.5 + 0x1p-52, 0.5, -1), Vec3(0.5 + 0x1p-52, 0.5, 1), Vec3(2, 2, 0)}));
}

TEST(Intersect, coplanarTrianglesMeetWhenTheirAreasDo) {
  EXPECT_TRUE(meet(kFlat, {Vec3(0.1, 0.1, 0), Vec3(0.2, 0.1, 0), Vec3(0.1, 0.2, 0)}));  // within
  EXPECT_TRUE(meet(kFlat, {Vec3(0.4, 0.4, 0), Vec3(2, 0, 0), Vec3(2, 2, 0)}));          // overlap
  EXPECT_TRUE(meet(kFlat, {Vec3(1, 0, 0), Vec3(2, 0, 0), Vec3(2, 1, 0)}));              // share a corner
  EXPECT_TRUE(meet(kFlat, {Vec3(0.2, 0, 0), Vec3(0.8, 0, 0), Vec3(0.5, -1, 0)}));       // along an edge
  EXPECT_TRUE(meet(kFlat, kFlat));
  EXPECT_FALSE(meet(kFlat, {Vec3(0.6, 0.6, 0), Vec3(2, 0, 0), Vec3(2, 2, 0)}));
  EXPECT_FALSE(meet(kFlat, {Vec3(1.01, 0, 0), Vec3(2, 0, 0), Vec3(2, 1, 0)}));
  const Triangle upright{Vec3(0, 0, 0), Vec3(0, 0, 1),
                         Vec3(0, 1, 0)};  // in a plane that two projections lose
  EXPECT_TRUE(meet(upright, {Vec3(0, 0.2, 0.2), Vec3(0, 2, 2), Vec3(0, 2, 3)}));
  EXPECT_FALSE(meet(upright, {Vec3(0, 0.6, 0.6), Vec3(0, 2, 2), Vec3(0, 2, 3)}));
}

TEST(Intersect, trianglesWithoutAreaCountAsTheirEdges) {
  const Triangle needle{Vec3(0.2, 0.2, -1), Vec3(0.2, 0.2, 0.5), Vec3(0.2, 0.2, 1)};
  EXPECT_TRUE(meet(kFlat, needle));
  EXPECT_FALSE(meet(kFlat, {Vec3(2, 2, -1), Vec3(2, 2, 0.5), Vec3(2, 2, 1)}));
  EXPECT_FALSE(meet(kFlat, {Vec3(0.2, 0.2, 1), Vec3(0.2, 0.2, 1), Vec3(0.2, 0.2, 1)}));
  EXPECT_TRUE(meet(kFlat, {Vec3(0.25, 0.25, 0), Vec3(0.25, 0.25, 0), Vec3(0.25, 0.25, 0)}));
}

TEST(Intersect, randomTrianglesAgreeWithPlainArithmetic) {
  // Random triangles are far from degenerate, so that plain arithmetic decides them unless a decision is
  // close.
  Numbers numbers(6);
  int seen = 0, apart = 0;
  for (int i = 0; i < 2000; ++i) {
    const Triangle a{numbers.point(1), numbers.point(1), numbers.point(1)};
    const Triangle b{numbers.point(1), numbers.point(1), numbers.point(1)};
    bool crossing = false;
    double margin = 1;  // how near the nearest decision was
    const auto edgesThrough = [&](const Triangle& p, const Triangle& t) {
      const Vec3 n = (t[1] - t[0]).cross(t[2] - t[0]);
      for (int k = 0; k < 3; ++k) {
        const Vec3 d = p[(k + 1) % 3] - p[k];
        const double s = n.dot(t[0] - p[k]) / n.dot(d);
        const Vec3 x = p[k] + s * d;
        const double u = n.dot((t[1] - t[0]).cross(x - t[0])) / n.squaredNorm();
        const double v = n.dot((t[2] - t[1]).cross(x - t[1])) / n.squaredNorm();
        const double w = n.dot((t[0] - t[2]).cross(x - t[2])) / n.squaredNorm();
        const double least = std::min({s, 1 - s, u, v, w});
        crossing |= least > 0;
        margin = std::min(margin, std::abs(least));
      }
    };
    edgesThrough(a, b);
    edgesThrough(b, a);
    if (margin < 1e-9) continue;
    EXPECT_EQ(meet(a, b), crossing);
    ++(crossing ? seen : apart);
  }
  EXPECT_GT(seen, 200);
  EXPECT_GT(apart, 200);
}

TEST(Intersect, meshesGiveThePairsOfBruteForce) {
  const TriMesh a = sphere({0, 0, 0}, 1, 2),
                b = moved(torus(0.9, 0.3, 14, 9), poseOf({0.4, 0.1, 0}, {1, 1, 0}, 0.8));
  std::vector<std::array<int, 2>> slow;
  for (int i = 0; i < static_cast<int>(a.triangles.size()); ++i) {
    for (int j = 0; j < static_cast<int>(b.triangles.size()); ++j) {
      Triangle ta, tb;
      for (int k = 0; k < 3; ++k) {
        ta[k] = a.vertices[a.triangles[i][k]];
        tb[k] = b.vertices[b.triangles[j][k]];
      }
      if (trianglesMeet(ta, tb)) slow.push_back({i, j});
    }
  }
  EXPECT_FALSE(slow.empty());
  EXPECT_EQ(intersectingTriangles(a, b), slow);
  EXPECT_TRUE(intersectingTriangles(a, sphere({3, 0, 0}, 1, 2)).empty());
  EXPECT_TRUE(intersectingTriangles(TriMesh{}, b).empty());
}

TEST(Intersect, selfIntersectionIgnoresNeighboursOnly) {
  EXPECT_TRUE(selfIntersections(sphere({0, 0, 0}, 1, 3)).empty());
  EXPECT_TRUE(selfIntersections(torus(0.7, 0.2, 12, 8)).empty());
  TriMesh both = box({0, 0, 0}, {1, 1, 1});
  const TriMesh second = box({0.5, 0.25, 0.25}, {1.5, 0.75, 0.75});
  for (const auto& t : second.triangles) both.triangles.push_back({t[0] + 8, t[1] + 8, t[2] + 8});
  both.vertices.insert(both.vertices.end(), second.vertices.begin(), second.vertices.end());
  const auto found = selfIntersections(both);
  EXPECT_FALSE(found.empty());
  for (const auto& [i, j] : found) {
    EXPECT_LT(i, 12);  // one of each box
    EXPECT_GE(j, 12);
  }
}

}  // namespace
}  // namespace glenoid
