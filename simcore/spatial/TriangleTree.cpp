// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/spatial/TriangleTree.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "simcore/spatial/RayParity.h"
#include "simcore/spatial/TrianglePoint.h"

namespace glenoid {
namespace {

std::array<Vec3, 3> cornersOf(const TriMesh& mesh, int triangle) {
  const auto& t = mesh.triangles[triangle];
  return {mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]};
}

BoxTree treeOf(const TriMesh& mesh) {
  std::vector<Box3> boxes(mesh.triangles.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    for (const int v : mesh.triangles[i]) boxes[i].extend(mesh.vertices[v]);
  }
  return BoxTree(boxes);
}

/// Distance along the unit direction at which the line enters the box, or a negative number for a miss.
double entry(const BoxTree::Node& node, const Vec3& origin, const Vec3& direction, double maxDistance) {
  double near = 0, far = maxDistance;
  for (int k = 0; k < 3; ++k) {
    if (direction[k] == 0) {
      if (origin[k] < node.low[k] || origin[k] > node.high[k]) return -1;
      continue;
    }
    double t0 = (node.low[k] - origin[k]) / direction[k], t1 = (node.high[k] - origin[k]) / direction[k];
    if (t0 > t1) std::swap(t0, t1);
    near = std::max(near, t0);
    far = std::min(far, t1);
    if (near > far) return -1;
  }
  return near;
}

/// Möller and Trumbore 1997, with edges widened by a relative 1e-12 so that no ray slips between neighbours.
bool meetLine(const std::array<Vec3, 3>& t, const Vec3& origin, const Vec3& direction, double& distance,
              Vec3& w) {
  const Vec3 e1 = t[1] - t[0], e2 = t[2] - t[0];
  const Vec3 p = direction.cross(e2);
  const double det = e1.dot(p);
  if (det == 0) return false;
  const Vec3 s = origin - t[0];
  const double u = s.dot(p) / det;
  const Vec3 q = s.cross(e1);
  const double v = direction.dot(q) / det;
  constexpr double slack = 1e-12;
  if (!(u >= -slack && v >= -slack && u + v <= 1 + slack)) return false;
  distance = e2.dot(q) / det;
  w = Vec3(1 - u - v, u, v);
  return true;
}

}  // namespace

TriangleTree::TriangleTree(const TriMesh& mesh) : m_mesh(mesh), m_tree(treeOf(mesh)) {}

TriangleTree::Closest TriangleTree::closest(const Vec3& point, double reach) const {
  Closest result;
  const double best = m_tree.nearest(point, reach * reach, [&](int item, double bestSoFar) {
    const auto t = cornersOf(m_mesh, item);
    const Vec3 w = nearestBarycentric(point, t[0], t[1], t[2]);
    const Vec3 x = w[0] * t[0] + w[1] * t[1] + w[2] * t[2];
    const double d = (x - point).squaredNorm();
    const bool lowerOfEquals = d == bestSoFar && result.triangle >= 0 && item < result.triangle;
    if (d < bestSoFar || lowerOfEquals) {
      result.triangle = item;
      result.point = x;
      result.barycentric = w;
    }
    return d;
  });
  if (result.triangle >= 0) result.distance = std::sqrt(best);
  return result;
}

bool TriangleTree::inside(const Vec3& point) const {
  return enclosedBy(m_tree, point, [&](int item) { return cornersOf(m_mesh, item); });
}

double TriangleTree::signedDistance(const Vec3& point) const {
  const double distance = closest(point).distance;
  return inside(point) ? -distance : distance;
}

void TriangleTree::overlapping(const Box3& box, std::vector<int>& out) const {
  out.clear();
  if (box.isEmpty()) return;
  const auto meets = [&](const BoxTree::Node& node) {
    for (int k = 0; k < 3; ++k) {
      if (node.low[k] > box.max()[k] || node.high[k] < box.min()[k]) return false;
    }
    return true;
  };
  // The leaf's box is a little too large; the triangle's own decides.
  m_tree.walk(meets, [&](int item) {
    Box3 own;
    for (const int v : m_mesh.triangles[item]) own.extend(m_mesh.vertices[v]);
    if (own.intersects(box)) out.push_back(item);
  });
  std::sort(out.begin(), out.end());
}

std::optional<RayHit> TriangleTree::cast(const Vec3& origin, const Vec3& direction,
                                         double maxDistance) const {
  const double length = direction.norm();
  if (!(length > 0) || !std::isfinite(length)) return std::nullopt;
  const Vec3 unit = direction / length;
  RayHit hit;
  double best = maxDistance;
  m_tree.walk([&](const BoxTree::Node& node) { return entry(node, origin, unit, best) >= 0; },
              [&](int item) {
                double distance;
                Vec3 w;
                if (!meetLine(cornersOf(m_mesh, item), origin, unit, distance, w)) return;
                const bool nearer =
                    distance < best || (distance == best && (hit.triangle < 0 || item < hit.triangle));
                if (distance < 0 || !nearer) return;
                best = distance;
                hit.triangle = item;
                hit.barycentric = w;
              });
  if (hit.triangle < 0) return std::nullopt;
  const auto t = cornersOf(m_mesh, hit.triangle);
  hit.distance = best;
  hit.point = origin + best * unit;
  hit.normal = (t[1] - t[0]).cross(t[2] - t[0]).normalized();
  return hit;
}

}  // namespace glenoid
