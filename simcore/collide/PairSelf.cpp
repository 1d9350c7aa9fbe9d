// SPDX-License-Identifier: GPL-3.0-or-later
// A surface with itself: the same search with both sides on one surface, and what its rest shape says of two features.
#include <cmath>

#include "simcore/collide/PairSearch.h"
#include "simcore/spatial/Intersect.h"
#include "simcore/spatial/RayParity.h"

namespace glenoid {

void PairSearch::runSelf(const Settings& settings, MovingSurface& surface, const FeatureOwners& owners, const SelfRest& rest,
                         std::vector<Proximity>& out, ProximityFinder::Counts& counts) {
  if (!surface.usable()) return;
  m_self = &rest;
  m_settings = settings;
  m_ahead = 2 * surface.ahead();
  m_touching = kTouching * settings.contactDistance;
  m_shallow = kShallow * settings.contactDistance;
  m_edgeDepth = m_limits.edgeDepth * surface.topology().thickness;
  m_swept = 0;  // both sides drift alike
  m_out = &out;
  m_counts = &counts;
  ++m_mark;
  prepare(m_a, surface, owners);
  prepare(m_b, surface, owners);
  m_facing.update(surface);
  surface.tree().walkSelf(
      [&](int ta, int tb) {
        if (!rest.trianglesShare(ta, tb)) trianglePair(ta, tb);
      },
      [this](int i, int j) { return m_facing.mayTouch(i, j); });
  followInside(m_a, m_b);
}

bool PairSearch::mayBeInside(int vertex, int triangle, double depth) const {
  if (!m_self) return true;
  if (m_self->farAndBehind(vertex, triangle, depth) || m_self->share(vertex, triangle)) return false;
  return SelfRest::cameFromOutside(m_self->vertexAndTriangle(vertex, triangle), depth);
}

double PairSearch::distanceOf(int vertex, int triangle) const {
  return SelfRest::contactDistance(m_settings.contactDistance, m_self->vertexAndTriangle(vertex, triangle));
}

bool PairSearch::covered(const Vec3& p, const Vec3& outward) const {
  const MovingSurface& surface = *m_a.surface;
  const AxisRay ray = shortestRay(p + 0.5 * m_touching * outward, surface.tree().nodes()[0]);
  const int u = (ray.axis + 1) % 3, v = (ray.axis + 2) % 3;
  int sum = 0;
  surface.tree().walk([&](const BoxTree::Node& node) { return ray.reaches(node); },
                      [&](int t) {
                        const auto [i, j, k] = surface.topology().triangles[t];
                        const Vec3 &a = surface.x(i), &b = surface.x(j), &c = surface.x(k);
                        if (ray.crosses(a, b, c)) sum += orient2d({a[u], a[v]}, {b[u], b[v]}, {c[u], c[v]});
                      });
  return (ray.forward ? sum : -sum) > 0;
}

MovingSurface::Nearest PairSearch::nearestTo(Side& other, int vertex, const Vec3& p, double reach) {
  if (!m_self) return other.surface->nearest(p, reach);
  return other.surface->nearestOf(p, reach, [&](int t, double squared) { return mayBeInside(vertex, t, std::sqrt(squared)); });
}

}  // namespace glenoid
