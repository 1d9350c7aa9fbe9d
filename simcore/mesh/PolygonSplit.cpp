// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/mesh/PolygonSplit.h"

#include <cmath>

namespace glenoid {
namespace {

double cross2(const Vec2& a, const Vec2& b) { return a.x() * b.y() - a.y() * b.x(); }

/// Twice the area over the square of the longest side: how good an ear is; below zero for a reflex corner.
double shapeOf(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double longest = std::max({(b - a).squaredNorm(), (c - b).squaredNorm(), (a - c).squaredNorm()});
  return longest > 0 ? cross2(b - a, c - a) / longest : 0;
}

bool holds(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& p) {
  return cross2(b - a, p - a) >= 0 && cross2(c - b, p - b) >= 0 && cross2(a - c, p - c) >= 0;
}

}  // namespace

void splitPolygon(const std::vector<Vec3>& points, std::span<const int> corners,
                  std::vector<std::array<int, 3>>& triangles) {
  const std::size_t n = corners.size();
  if (n < 3) return;
  if (n == 3 || n > 1000) {
    for (std::size_t i = 1; i + 1 < n; ++i) triangles.push_back({corners[0], corners[i], corners[i + 1]});
    return;
  }
  Vec3 normal = Vec3::Zero();
  for (std::size_t i = 0; i < n; ++i)
    normal += (points[corners[i]] - points[corners[0]]).cross(points[corners[(i + 1) % n]] - points[corners[0]]);
  Vec3 u = Vec3::UnitX(), v = Vec3::UnitY();
  if (normal.norm() > 0) {
    int least = 0;
    normal.cwiseAbs().minCoeff(&least);
    u = normal.normalized().cross(Vec3::Unit(least)).normalized();
    v = normal.normalized().cross(u);
  }
  std::vector<Vec2> flat(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Vec3 d = points[corners[i]] - points[corners[0]];
    flat[i] = Vec2(d.dot(u), d.dot(v));
  }
  std::vector<std::size_t> ring(n);
  for (std::size_t i = 0; i < n; ++i) ring[i] = i;
  while (ring.size() > 3) {
    const std::size_t m = ring.size();
    std::size_t best = 0;
    double bestShape = -HUGE_VAL;
    for (std::size_t i = 0; i < m; ++i) {
      const std::size_t a = ring[(i + m - 1) % m], b = ring[i], c = ring[(i + 1) % m];
      double shape = shapeOf(flat[a], flat[b], flat[c]);
      for (std::size_t j = 0; j < m && shape > 0; ++j)
        if (ring[j] != a && ring[j] != b && ring[j] != c && holds(flat[a], flat[b], flat[c], flat[ring[j]]))
          shape = -1;  // no ear; taken only when there is none at all
      if (shape > bestShape) best = i, bestShape = shape;
    }
    triangles.push_back({corners[ring[(best + m - 1) % m]], corners[ring[best]], corners[ring[(best + 1) % m]]});
    ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(best));
  }
  triangles.push_back({corners[ring[0]], corners[ring[1]], corners[ring[2]]});
}

}  // namespace glenoid
