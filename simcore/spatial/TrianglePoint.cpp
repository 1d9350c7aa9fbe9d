// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/spatial/TrianglePoint.h"

#include <algorithm>

namespace glenoid {
namespace {

/// Weight of b for the point of segment ab that is nearest to p.
double alongSegment(const Vec3& p, const Vec3& a, const Vec3& b) {
  const Vec3 ab = b - a;
  const double length2 = ab.squaredNorm();
  return length2 > 0 ? std::clamp(ab.dot(p - a) / length2, 0.0, 1.0) : 0.0;
}

/// Best of the three edges; only for triangles without area.
Vec3 nearestOnEdges(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const double ab = alongSegment(p, a, b), bc = alongSegment(p, b, c), ca = alongSegment(p, c, a);
  const Vec3 candidates[3] = {{1 - ab, ab, 0}, {0, 1 - bc, bc}, {ca, 0, 1 - ca}};
  Vec3 best = candidates[0];
  double least = -1;
  for (const Vec3& w : candidates) {
    const double d = (w[0] * a + w[1] * b + w[2] * c - p).squaredNorm();
    if (least < 0 || d < least) {
      least = d;
      best = w;
    }
  }
  return best;
}

}  // namespace

Vec3 nearestBarycentric(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 ab = b - a, ac = c - a, ap = p - a;
  const double d1 = ab.dot(ap), d2 = ac.dot(ap);
  if (d1 <= 0 && d2 <= 0) return {1, 0, 0};
  const Vec3 bp = p - b;
  const double d3 = ab.dot(bp), d4 = ac.dot(bp);
  if (d3 >= 0 && d4 <= d3) return {0, 1, 0};
  const Vec3 cp = p - c;
  const double d5 = ab.dot(cp), d6 = ac.dot(cp);
  if (d6 >= 0 && d5 <= d6) return {0, 0, 1};
  const double vc = d1 * d4 - d3 * d2;
  if (vc <= 0 && d1 >= 0 && d3 <= 0 && d1 > d3) {
    const double v = d1 / (d1 - d3);
    return {1 - v, v, 0};
  }
  const double vb = d5 * d2 - d1 * d6;
  if (vb <= 0 && d2 >= 0 && d6 <= 0 && d2 > d6) {
    const double w = d2 / (d2 - d6);
    return {1 - w, 0, w};
  }
  const double va = d3 * d6 - d5 * d4;
  if (va <= 0 && d4 >= d3 && d5 >= d6 && (d4 - d3) + (d5 - d6) > 0) {
    const double w = (d4 - d3) / ((d4 - d3) + (d5 - d6));
    return {0, 1 - w, w};
  }
  const double total = va + vb + vc;
  if (!(va > 0 && vb > 0 && vc > 0 && total > 0)) return nearestOnEdges(p, a, b, c);
  const double v = vb / total, w = vc / total;
  return {1 - v - w, v, w};
}

}  // namespace glenoid
