// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/embed/TriangleInTet.h"

#include <algorithm>

namespace glenoid {
namespace {

bool separates(const Vec3& axis, const std::array<Vec3, 3>& triangle, const std::array<Vec3, 4>& tet,
               double tolerance, double shortest) {
  const double length = axis.norm();
  if (length <= shortest) return false;
  double aMin = axis.dot(triangle[0]), aMax = aMin, bMin = axis.dot(tet[0]), bMax = bMin;
  for (int i = 1; i < 3; ++i) {
    const double x = axis.dot(triangle[i]);
    aMin = std::min(aMin, x), aMax = std::max(aMax, x);
  }
  for (int i = 1; i < 4; ++i) {
    const double x = axis.dot(tet[i]);
    bMin = std::min(bMin, x), bMax = std::max(bMax, x);
  }
  return std::min(aMax - bMin, bMax - aMin) <= tolerance * length;
}

}  // namespace

bool triangleReachesInto(const std::array<Vec3, 3>& triangle, const std::array<Vec3, 4>& tet,
                         double tolerance) {
  constexpr int kFaces[4][3] = {{1, 2, 3}, {0, 3, 2}, {0, 1, 3}, {0, 2, 1}};
  constexpr int kEdges[6][2] = {{0, 1}, {0, 2}, {0, 3}, {1, 2}, {1, 3}, {2, 3}};
  // Relative to a corner of the tetrahedron the projections keep their digits.
  std::array<Vec3, 3> p;
  std::array<Vec3, 4> q;
  for (int i = 0; i < 3; ++i) p[i] = triangle[i] - tet[0];
  for (int i = 0; i < 4; ++i) q[i] = tet[i] - tet[0];
  for (const auto& f : kFaces)
    if (separates((q[f[1]] - q[f[0]]).cross(q[f[2]] - q[f[0]]), p, q, tolerance, 0)) return false;
  const std::array<Vec3, 3> edges{p[1] - p[0], p[2] - p[1], p[0] - p[2]};
  if (separates(edges[0].cross(edges[1]), p, q, tolerance, 0)) return false;
  for (const Vec3& x : edges)
    for (const auto& e : kEdges) {
      const Vec3 y = q[e[1]] - q[e[0]];
      if (separates(x.cross(y), p, q, tolerance, 1e-9 * x.norm() * y.norm())) return false;
    }
  return true;
}

}  // namespace glenoid
