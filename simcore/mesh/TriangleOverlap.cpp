// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/mesh/TriangleOverlap.h"

#include <algorithm>

namespace glenoid {
namespace {

/// True when the projections on `axis` overlap by no more than `tolerance`; an axis without length says
/// nothing.
bool separates(const Vec3& axis, double scale, const Triangle3& a, const Triangle3& b, double tolerance) {
  const double length = axis.norm();
  if (length <= 1e-9 * scale) return false;
  double aMin = axis.dot(a[0]), aMax = aMin, bMin = axis.dot(b[0]), bMax = bMin;
  for (int i = 1; i < 3; ++i) {
    const double x = axis.dot(a[i]), y = axis.dot(b[i]);
    aMin = std::min(aMin, x), aMax = std::max(aMax, x);
    bMin = std::min(bMin, y), bMax = std::max(bMax, y);
  }
  return std::min(aMax - bMin, bMax - aMin) <= tolerance * length;
}

}  // namespace

bool trianglesOverlap(const Triangle3& a, const Triangle3& b, double tolerance) {
  // Near the origin the projections keep their digits.
  const Vec3 shift = a[0];
  Triangle3 p, q;
  for (int i = 0; i < 3; ++i) p[i] = a[i] - shift, q[i] = b[i] - shift;
  std::array<Vec3, 3> ep, eq;
  double sp = 0, sq = 0;
  for (int i = 0; i < 3; ++i) {
    ep[i] = p[(i + 1) % 3] - p[i], eq[i] = q[(i + 1) % 3] - q[i];
    sp = std::max(sp, ep[i].norm()), sq = std::max(sq, eq[i].norm());
  }
  const Vec3 np = ep[0].cross(ep[1]), nq = eq[0].cross(eq[1]);
  if (separates(np, sp * sp, p, q, tolerance) || separates(nq, sq * sq, p, q, tolerance)) return false;
  for (const Vec3& x : ep)
    for (const Vec3& y : eq)
      if (separates(x.cross(y), sp * sq, p, q, tolerance)) return false;
  for (int i = 0; i < 3; ++i)
    if (separates(np.cross(ep[i]), sp * sp * sp, p, q, tolerance) ||
        separates(nq.cross(eq[i]), sq * sq * sq, p, q, tolerance))
      return false;
  return true;
}

bool segmentPierces(const Vec3& p, const Vec3& q, const Triangle3& t, double tolerance) {
  const Vec3 normal = (t[1] - t[0]).cross(t[2] - t[0]);
  const double length = normal.norm();
  if (!(length > 0)) return false;
  const double hp = normal.dot(p - t[0]) / length, hq = normal.dot(q - t[0]) / length;
  if (!((hp > tolerance && hq < -tolerance) || (hp < -tolerance && hq > tolerance))) return false;
  const Vec3 x = p + (q - p) * (hp / (hp - hq));
  for (int i = 0; i < 3; ++i) {
    const Vec3 edge = t[(i + 1) % 3] - t[i];
    if (edge.cross(x - t[i]).dot(normal) <= tolerance * length * edge.norm()) return false;
  }
  return true;
}

bool fansCross(const Triangle3& a, const Triangle3& b, double tolerance) {
  return segmentPierces(a[1], a[2], b, tolerance) || segmentPierces(b[1], b[2], a, tolerance);
}

bool trianglesCut(const TriMesh& mesh, int a, int b, double tolerance) {
  const auto &ta = mesh.triangles[a], &tb = mesh.triangles[b];
  int common = 0, atA = 0, atB = 0;
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j)
      if (ta[i] == tb[j]) ++common, atA = i, atB = j;
  if (common > 1) return false;
  Triangle3 p, q;
  for (int i = 0; i < 3; ++i)
    p[i] = mesh.vertices[ta[(atA + i) % 3]], q[i] = mesh.vertices[tb[(atB + i) % 3]];
  return common == 1 ? fansCross(p, q, tolerance) : trianglesOverlap(p, q, tolerance);
}

}  // namespace glenoid
