// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/collide/SelfPenetration.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "simcore/spatial/Intersect.h"
#include "simcore/spatial/RayParity.h"
#include "simcore/spatial/TrianglePoint.h"

namespace glenoid {
namespace {

/// How far in front of a point it is asked whether there is body, as a share of the surface's size.
constexpr double kInFront = 1e-6;
/// Cosine of the angle between the way to a triangle and that triangle's normal from which a point lies behind it: what lies
/// beside it in the same layer, flat or nearly, does not count.
constexpr double kBehind = 0.5;

bool share(const std::array<int, 3>& a, const std::array<int, 3>& b) {
  return std::any_of(a.begin(), a.end(), [&](int v) { return v == b[0] || v == b[1] || v == b[2]; });
}

}  // namespace

std::array<Vec3, 3> SelfPenetration::corners(int t) const {
  const auto [i, j, k] = m_surface->triangles[t];
  return {m_x[i], m_x[j], m_x[k]};
}

Vec3 SelfPenetration::faceNormal(int t) const {
  const auto c = corners(t);
  return (c[1] - c[0]).cross(c[2] - c[0]);
}

/// Whether triangles without a common vertex meet; where edges go through triangles, ascending.
bool SelfPenetration::crossings() {
  const auto& triangles = m_surface->triangles;
  m_crossings.clear();
  bool any = false;
  const auto edgesThrough = [&](int tm, int to) {
    const auto c = corners(to);
    for (const int e : m_surface->triangleEdges[tm]) {
      const CollisionSurface::Edge& edge = m_surface->edges[e];
      if (edge.triangles[0] != tm && edge.triangles[1] != tm) continue;
      const Vec3 &p = m_x[edge.vertices[0]], &q = m_x[edge.vertices[1]];
      if (!segmentMeetsTriangle(p, q, c)) continue;
      const Vec3 n = (c[1] - c[0]).cross(c[2] - c[0]);
      const double hp = n.dot(p - c[0]), hq = n.dot(q - c[0]);
      if (hp != hq) m_crossings.push_back({e, std::clamp(hp / (hp - hq), 0.0, 1.0)});
    }
  };
  m_tree->walkSelf(
      [&](int a, int b) {
        if (share(triangles[a], triangles[b]) || !trianglesMeet(corners(a), corners(b))) return;
        any = true;
        edgesThrough(a, b);
        edgesThrough(b, a);
      },
      [](int, int) { return true; });
  // An edge is met from both of its triangles; two crossings at one place leave nothing between them.
  std::sort(m_crossings.begin(), m_crossings.end(), [](const Crossing& a, const Crossing& b) { return a.edge != b.edge ? a.edge < b.edge : a.t < b.t; });
  return any;
}

/// How many times the surface goes round a point: the crossings of a ray, outward ones up, inward ones down.
int SelfPenetration::winding(const Vec3& p) const {
  const AxisRay ray = shortestRay(p, m_tree->nodes()[0]);
  const int u = (ray.axis + 1) % 3, v = (ray.axis + 2) % 3;
  int sum = 0;
  m_tree->walk([&](const BoxTree::Node& node) { return ray.reaches(node); },
               [&](int t) {
                 const auto c = corners(t);
                 if (!ray.crosses(c[0], c[1], c[2])) return;
                 sum += orient2d({c[0][u], c[0][v]}, {c[1][u], c[1][v]}, {c[2][u], c[2][v]});
               });
  return ray.forward ? sum : -sum;
}

bool SelfPenetration::inside(const Vec3& p, const Vec3& normal) const {
  const Vec3 front = p + kInFront * m_surface->size * normal;
  const BoxTree::Node& root = m_tree->nodes()[0];
  for (int k = 0; k < 3; ++k)
    if (front[k] < root.low[k] || front[k] > root.high[k]) return false;
  return winding(front) > 0;
}

/// Distance from a point of the surface that is inside to where it came in; `own`: triangles on which it lies. Asked, as
/// inside() is, of the place just in front of it: what rests on another layer is inside or not by less than that.
double SelfPenetration::depthOf(const Vec3& x, const Vec3& normal, std::span<const int> own) const {
  const double inFront = kInFront * m_surface->size;
  const Vec3 p = x + inFront * normal;
  const double none = std::numeric_limits<double>::infinity();
  const double best = m_tree->nearest(p, none, [&](int t, double bestSoFar) {
    if (m_surface->empty[t] || std::find(own.begin(), own.end(), t) != own.end()) return none;
    const auto c = corners(t);
    const Vec3 w = nearestBarycentric(p, c[0], c[1], c[2]);
    const Vec3 way = w[0] * c[0] + w[1] * c[1] + w[2] * c[2] - p;
    const double d = way.squaredNorm();
    if (d >= bestSoFar || faceNormal(t).stableNormalized().dot(way) < kBehind * std::sqrt(d)) return none;
    return d;
  });
  return best < none ? std::max(0.0, std::sqrt(best) - inFront) : 0.0;
}

void SelfPenetration::look(const CollisionSurface& surface, const BoxTree& tree, std::span<const Vec3> x, const Found& found) {
  m_surface = &surface;
  m_tree = &tree;
  m_x = x;
  if (tree.empty() || !crossings()) return;
  m_normals.assign(surface.vertexCount, Vec3::Zero());
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t)
    if (!surface.empty[t])
      for (const int v : surface.triangles[t]) m_normals[v] += faceNormal(t);
  m_inside.assign(surface.vertexCount, 0);
  for (int v = 0; v < surface.vertexCount; ++v) {
    if (m_normals[v].isZero(0)) continue;
    m_normals[v].stableNormalize();
    m_inside[v] = inside(x[v], m_normals[v]);
    if (m_inside[v]) found(x[v], depthOf(x[v], m_normals[v], surface.trianglesOf(v)));
  }
  std::size_t next = 0;
  for (int e = 0; e < static_cast<int>(surface.edges.size()); ++e) {
    const std::size_t first = next;
    while (next < m_crossings.size() && m_crossings[next].edge == e) ++next;
    const CollisionSurface::Edge& edge = surface.edges[e];
    if (edge.triangles[1] < 0 || (first == next && !(m_inside[edge.vertices[0]] && m_inside[edge.vertices[1]]))) continue;
    const Vec3 normal = (faceNormal(edge.triangles[0]).stableNormalized() + faceNormal(edge.triangles[1]).stableNormalized()).stableNormalized();
    const Vec3 &x0 = x[edge.vertices[0]], &x1 = x[edge.vertices[1]];
    double from = 0;
    for (std::size_t i = first; i <= next; ++i) {
      const double to = i < next ? m_crossings[i].t : 1;
      const auto at = [&](double share) -> Vec3 { return x0 + (from + share * (to - from)) * (x1 - x0); };
      if (to > from)
        for (const double share : {0.25, 0.5, 0.75})
          if (inside(at(share), normal)) found(at(share), depthOf(at(share), normal, edge.triangles));
      from = to;
    }
  }
}

}  // namespace glenoid
