// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/spatial/Intersect.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simcore/spatial/BoxTree.h"
#include "simcore/spatial/Expansion.h"

namespace glenoid {
namespace {

// Rounding unit of Shewchuk's bounds: half the distance from 1 to the next double.
constexpr double kUnit = std::numeric_limits<double>::epsilon() / 2;
constexpr double kBound2d = (3 + 16 * kUnit) * kUnit;
constexpr double kBound3d = (7 + 56 * kUnit) * kUnit;

int signOf(double x) {
  return (x > 0) - (x < 0);
}

int orient3dExact(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  using namespace expansion;
  std::array<Expansion<2>, 3> u, v, w;
  for (int k = 0; k < 3; ++k) {
    u[k] = difference(b[k], a[k]);
    v[k] = difference(c[k], a[k]);
    w[k] = difference(d[k], a[k]);
  }
  const auto minor = [&](int i, int j) { return sum(product(u[i], v[j]), product(u[j], v[i]), -1); };
  const auto first = product(minor(1, 2), w[0]);
  const auto second = product(minor(2, 0), w[1]);
  const auto third = product(minor(0, 1), w[2]);
  return sum(sum(first, second), third).sign();
}

int orient2dExact(const Vec2& a, const Vec2& b, const Vec2& c) {
  using namespace expansion;
  return sum(product(difference(b.x(), a.x()), difference(c.y(), a.y())),
             product(difference(b.y(), a.y()), difference(c.x(), a.x())), -1)
      .sign();
}

/// The two coordinates that are left when `axis` is dropped.
Vec2 without(const Vec3& p, int axis) {
  return {p[(axis + 1) % 3], p[(axis + 2) % 3]};
}

bool segmentsMeet2d(const Vec2& p, const Vec2& q, const Vec2& r, const Vec2& s) {
  for (int k = 0; k < 2; ++k) {
    if (std::max(p[k], q[k]) < std::min(r[k], s[k]) || std::max(r[k], s[k]) < std::min(p[k], q[k]))
      return false;
  }
  return orient2d(p, q, r) * orient2d(p, q, s) <= 0 && orient2d(r, s, p) * orient2d(r, s, q) <= 0;
}

/// In a plane, two segments meet exactly when all three axis projections do: one of them is one-to-one there.
bool segmentsMeet3d(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& s) {
  if (orient3d(p, q, r, s) != 0) return false;
  for (int axis = 0; axis < 3; ++axis) {
    if (!segmentsMeet2d(without(p, axis), without(q, axis), without(r, axis), without(s, axis))) return false;
  }
  return true;
}

/// For a point in the plane of the triangle; a triangle without area holds nothing beyond its edges.
bool coplanarPointInside(const Vec3& p, const std::array<Vec3, 3>& t) {
  for (int axis = 0; axis < 3; ++axis) {
    const Vec2 a = without(t[0], axis), b = without(t[1], axis), c = without(t[2], axis),
               x = without(p, axis);
    const int turn = orient2d(a, b, c);
    if (turn == 0) continue;
    return orient2d(a, b, x) * turn >= 0 && orient2d(b, c, x) * turn >= 0 && orient2d(c, a, x) * turn >= 0;
  }
  return false;
}

bool coplanarSegmentMeets(const Vec3& p, const Vec3& q, const std::array<Vec3, 3>& t) {
  for (int k = 0; k < 3; ++k) {
    if (segmentsMeet3d(p, q, t[k], t[(k + 1) % 3])) return true;
  }
  return coplanarPointInside(p, t);
}

/// sp, sq: on which side of the triangle's plane the ends are.
bool segmentMeets(const Vec3& p, const Vec3& q, int sp, int sq, const std::array<Vec3, 3>& t) {
  if (sp == 0 && sq == 0) return coplanarSegmentMeets(p, q, t);
  if (sp * sq > 0) return false;
  const int a = orient3d(p, q, t[0], t[1]), b = orient3d(p, q, t[1], t[2]), c = orient3d(p, q, t[2], t[0]);
  return (a >= 0 && b >= 0 && c >= 0) || (a <= 0 && b <= 0 && c <= 0);
}

std::array<Vec3, 3> corners(const TriMesh& mesh, int triangle) {
  const auto& t = mesh.triangles[triangle];
  return {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
}

BoxTree treeOf(const TriMesh& mesh) {
  std::vector<Box3> boxes(mesh.triangles.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (const Vec3& x : corners(mesh, static_cast<int>(i))) boxes[i].extend(x);
  }
  return BoxTree(boxes);
}

bool shareVertex(const std::array<int, 3>& a, const std::array<int, 3>& b) {
  for (const int i : a) {
    if (i == b[0] || i == b[1] || i == b[2]) return true;
  }
  return false;
}

}  // namespace

int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d) {
  const Vec3 u = b - a, v = c - a, w = d - a;
  const double yz = u.y() * v.z(), zy = u.z() * v.y();
  const double zx = u.z() * v.x(), xz = u.x() * v.z();
  const double xy = u.x() * v.y(), yx = u.y() * v.x();
  const double det = (yz - zy) * w.x() + (zx - xz) * w.y() + (xy - yx) * w.z();
  const double magnitude = (std::abs(yz) + std::abs(zy)) * std::abs(w.x()) +
                           (std::abs(zx) + std::abs(xz)) * std::abs(w.y()) +
                           (std::abs(xy) + std::abs(yx)) * std::abs(w.z());
  if (std::abs(det) > kBound3d * magnitude) return signOf(det);
  return orient3dExact(a, b, c, d);
}

int orient2d(const Vec2& a, const Vec2& b, const Vec2& c) {
  const double left = (b.x() - a.x()) * (c.y() - a.y()), right = (b.y() - a.y()) * (c.x() - a.x());
  const double det = left - right;
  if (std::abs(det) > kBound2d * (std::abs(left) + std::abs(right))) return signOf(det);
  return orient2dExact(a, b, c);
}

bool segmentMeetsTriangle(const Vec3& p, const Vec3& q, const std::array<Vec3, 3>& t) {
  return segmentMeets(p, q, orient3d(t[0], t[1], t[2], p), orient3d(t[0], t[1], t[2], q), t);
}

bool trianglesMeet(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b) {
  std::array<int, 3> sideA, sideB;
  for (int k = 0; k < 3; ++k) sideA[k] = orient3d(b[0], b[1], b[2], a[k]);
  if (sideA[0] * sideA[1] > 0 && sideA[0] * sideA[2] > 0) return false;
  for (int k = 0; k < 3; ++k) sideB[k] = orient3d(a[0], a[1], a[2], b[k]);
  if (sideB[0] * sideB[1] > 0 && sideB[0] * sideB[2] > 0) return false;
  // Two triangles that meet do so along a segment, or a polygon in one plane; some edge reaches it.
  for (int k = 0; k < 3; ++k) {
    const int next = (k + 1) % 3;
    if (segmentMeets(a[k], a[next], sideA[k], sideA[next], b)) return true;
    if (segmentMeets(b[k], b[next], sideB[k], sideB[next], a)) return true;
  }
  return false;
}

std::vector<std::array<int, 2>> intersectingTriangles(const TriMesh& a, const TriMesh& b) {
  std::vector<std::array<int, 2>> found;
  BoxTree::walkPairs(treeOf(a), treeOf(b), [&](int i, int j) {
    if (trianglesMeet(corners(a, i), corners(b, j))) found.push_back({i, j});
  });
  std::sort(found.begin(), found.end());
  return found;
}

std::vector<std::array<int, 2>> selfIntersections(const TriMesh& mesh) {
  std::vector<std::array<int, 2>> found;
  const BoxTree tree = treeOf(mesh);
  BoxTree::walkPairs(tree, tree, [&](int i, int j) {
    if (i >= j || shareVertex(mesh.triangles[i], mesh.triangles[j])) return;
    if (trianglesMeet(corners(mesh, i), corners(mesh, j))) found.push_back({i, j});
  });
  std::sort(found.begin(), found.end());
  return found;
}

}  // namespace glenoid
