// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/spatial/RayParity.h"

#include "simcore/spatial/Intersect.h"

namespace glenoid {
namespace {

/// Sign of orient2d(a, b, p + (ε, ε²)); 0 only when a and b are the same point.
int shiftedTurn(const Vec2& a, const Vec2& b, const Vec2& p) {
  const int turn = orient2d(p, a, b);
  if (turn != 0) return turn;
  if (a.y() != b.y()) return a.y() > b.y() ? 1 : -1;
  if (a.x() != b.x()) return b.x() > a.x() ? 1 : -1;
  return 0;
}

}  // namespace

bool AxisRay::crosses(const Vec3& a, const Vec3& b, const Vec3& c) const {
  const int u = (axis + 1) % 3, v = (axis + 2) % 3;
  const Vec2 a2(a[u], a[v]), b2(b[u], b[v]), c2(c[u], c[v]), p2(origin[u], origin[v]);
  const int turn = shiftedTurn(a2, b2, p2);
  if (turn == 0 || shiftedTurn(b2, c2, p2) != turn || shiftedTurn(c2, a2, p2) != turn) return false;
  const int side = orient3d(a, b, c, origin) * turn;  // < 0: the origin is before the triangle along the axis
  return forward ? side < 0 : side > 0;
}

AxisRay shortestRay(const Vec3& origin, const BoxTree::Node& root) {
  AxisRay ray{origin, 0, true};
  double shortest = root.high[0] - origin[0];
  for (int k = 0; k < 3; ++k) {
    const double up = root.high[k] - origin[k], down = origin[k] - root.low[k];
    if (up < shortest) {
      shortest = up;
      ray.axis = k;
      ray.forward = true;
    }
    if (down < shortest) {
      shortest = down;
      ray.axis = k;
      ray.forward = false;
    }
  }
  return ray;
}

}  // namespace glenoid
