// SPDX-License-Identifier: GPL-3.0-or-later
// Edges that cross edges of the other surface.
#include <algorithm>
#include <cmath>

#include "simcore/collide/FeatureKey.h"
#include "simcore/collide/FeaturePoints.h"
#include "simcore/collide/PairSearch.h"

namespace glenoid {
namespace {

/// Squared sine of the angle below which two edges are parallel: their ends say it better.
constexpr double kParallel = 1e-6;
/// Two crossed edges must be at least this share of their overlap below the other's surface.
constexpr double kWedge = 0.4;
/// Cosine of the angle by which the normal may differ from those beside an edge that is flat or a shallow valley.
constexpr double kAlmostFlat = 0.85;

/// How far below the nearer of an edge's two planes a point comes that goes in against the unit normal n, a share of
/// its way; negative: it leaves the wedge.
double wedgeDepth(const MovingSurface& surface, int e, const Vec3& n) {
  const auto& triangles = surface.topology().edges[e].triangles;
  return std::min(n.dot(surface.faceNormal(triangles[0])), n.dot(surface.faceNormal(triangles[1])));
}

}  // namespace

/// Whether a plane with the unit normal n, at right angles to the edge, is one that the edge's surface stays under
/// nearby: n lies in the arc between the normals of a convex edge, widened, now or as its faces will have turned by the
/// end of the step; or is close to both normals of a flat edge or a shallow valley. A skipped face sets no bound, but for
/// the side on which the surface lies.
bool PairSearch::facesAlong(const Side& side, int e, const Vec3& n) const {
  MovingSurface& surface = *side.surface;
  const CollisionSurface::Edge& edge = surface.topology().edges[e];
  if (surface.bend(e) == MovingSurface::Bend::Dentable) return wedgeDepth(surface, e, n) > kAlmostFlat;
  const Vec3 &on = surface.x(edge.vertices[0]), along = surface.x(edge.vertices[1]) - on;
  const double length = along.norm();
  for (int k = 0; k < 2; ++k) {
    if (side.owners->skipped(edge.triangles[k])) {
      if (n.dot(surface.edgeNormal(e)) <= 0) return false;
      continue;
    }
    const int v = edge.opposite[k];
    const Vec3 across = surface.x(v) - on;
    double above = n.dot(across);
    const double allowed = kWidened * across.cross(along).norm() / length;
    if (above <= allowed) continue;
    double change = 0;
    for (int motion = 0; motion < m_settings.motionCount; ++motion)
      change = std::max(change, m_settings.dt * n.dot(surface.v(motion, edge.vertices[0]) - surface.v(motion, v)));
    if (above - change > allowed) return false;
  }
  return true;
}

/// Sine of the angle by which past an edge's end, at a vertex, its surface rises over the plane with the unit normal n that touches
/// it along the edge; 0 where it does not rise by more than bumps do. Where it does, two features bound what slides there.
double PairSearch::riseBeyond(const Side& side, int e, int end, const Vec3& n) const {
  const MovingSurface& surface = *side.surface;
  const CollisionSurface& s = surface.topology();
  const int v = s.edges[e].vertices[end];
  const Vec3 out = surface.x(v) - surface.x(s.edges[e].vertices[1 - end]);
  double steepest = kWidened;
  for (const int other : s.edgesOf(v)) {
    if (!side.owners->edgeTakesPart[other]) continue;
    const auto& ends = s.edges[other].vertices;
    const Vec3 way = surface.x(ends[0] == v ? ends[1] : ends[0]) - surface.x(v);
    const double length = way.norm();
    if (way.dot(out) > 0 && n.dot(way) > steepest * length) steepest = n.dot(way) / length;
  }
  return steepest > kWidened ? steepest : 0;
}

void PairSearch::edgeNearEdge(int ea, int eb) {
  if (m_self) {
    if (m_self->edgesShare(ea, eb)) return;
    if (eb < ea) std::swap(ea, eb);
  }
  ++m_counts->edgeEdge;
  MovingSurface &a = *m_a.surface, &b = *m_b.surface;
  const CollisionSurface::Edge &edgeA = a.topology().edges[ea], &edgeB = b.topology().edges[eb];
  const Vec3 &a0 = a.x(edgeA.vertices[0]), &b0 = b.x(edgeB.vertices[0]);
  const Vec3 da = a.x(edgeA.vertices[1]) - a0, db = b.x(edgeB.vertices[1]) - b0, between = b0 - a0;
  Vec3 n = da.cross(db);
  const double n2 = n.squaredNorm();
  if (n2 <= kParallel * da.squaredNorm() * db.squaredNorm()) return;
  const double furthest = std::max(m_settings.contactDistance + m_ahead, m_edgeDepth);
  const double offset = n.dot(between);
  if (offset * offset > furthest * furthest * n2) return;
  // Times n2. Most pairs end here.
  const double s = between.cross(db).dot(n), t = between.cross(da).dot(n);
  const double pastA = std::max({-s, s - n2, 0.0}), pastB = std::max({-t, t - n2, 0.0});
  const double past = std::max(pastA * pastA * da.squaredNorm(), pastB * pastB * db.squaredNorm());
  const double slideMost = m_settings.contactDistance;
  if (past > slideMost * slideMost * n2 * n2) return;
  const bool within = s > 0 && s < n2 && t > 0 && t < n2;

  // n from b to a, by the side of the edges on which their faces lie.
  const bool dentableB = b.bend(eb) == MovingSurface::Bend::Dentable;
  n /= std::sqrt(n2);
  if (dentableB ? n.dot(b.edgeNormal(eb)) < 0 : n.dot(b.x(edgeB.opposite[0]) + b.x(edgeB.opposite[1]) - 2 * b0) > 0) n = -n;
  const double gap = -n.dot(between);
  if (gap < -m_edgeDepth) return;
  if (!facesAlong(m_b, eb, n) || !facesAlong(m_a, ea, -n)) return;

  Proximity contact;
  contact.pair = m_settings.pair;
  const double onA = std::clamp(s / n2, 0.0, 1.0), onB = std::clamp(t / n2, 0.0, 1.0);
  contact.a = edgePoint(edgeA, onA);
  contact.b = edgePoint(edgeB, onB);
  if (!within) {
    double slide = std::max(m_touching, -gap), closing = 0;
    for (int motion = 0; motion < m_settings.motionCount; ++motion) {
      const Vec3 way = m_settings.dt * (velocityOf(a, motion, contact.a) - velocityOf(b, motion, contact.b));
      slide = std::max(slide, (way - way.dot(n) * n).norm());
      closing = std::max(closing, -way.dot(n));
    }
    if (past > slide * slide * n2 * n2) return;
    // Sliding brings them nearer to the plane by the sine of what rises at most.
    const auto reaches = [&](double rise) { return rise > 0 && gap - closing < slide * rise; };
    if (!(s > 0 && s < n2) && !reaches(riseBeyond(m_a, ea, s > 0, -n))) return;
    if (!(t > 0 && t < n2) && !reaches(riseBeyond(m_b, eb, t > 0, n))) return;
  }
  contact.normal_W = n;
  contact.gap = gap;
  double distance = m_settings.contactDistance;
  if (m_self) {
    const SelfRest::Apart apart = m_self->edges(ea, eb);
    if (gap < 0 && !SelfRest::cameFromOutside(apart, -gap)) return;
    distance = SelfRest::contactDistance(distance, apart);
    if (m_self->sameCell(contact.a, contact.b)) return;
    if (gap < -m_touching && !covered(a0 + onA * da, -n) && !covered(b0 + onB * db, n)) return;
  }
  if (!near(distance, gap, n, a, contact.a, b, contact.b)) return;
  if (gap < -m_shallow) {
    // Two wedges that a plane touches along both may just have met. Deeper ones must prove it: where the foot of one edge lies
    // in the other's wedge it must truly be inside. A wedge that leans over so far that it cannot hold the foot says nothing;
    // one of the two has to.
    const bool inA = wedgeDepth(a, ea, -n) > kWedge, inB = wedgeDepth(b, eb, n) > kWedge;
    const double least = -kWedge * gap;
    if (!inA && !inB) return;
    if (inB && !inDepth(m_b, ea, onA, a0 + onA * da, least)) return;
    if (inA && !inDepth(m_a, eb, onB, b0 + onB * db, least)) return;
  }
  contact.key = FeatureKey::make(m_settings.pair, FeatureKind::Edge, ea, FeatureKind::Edge, eb);
  m_next.resize(m_out->size() + 1);
  m_next[m_out->size()] = -1;
  m_out->push_back(contact);
}

bool PairSearch::inDepth(Side& side, int edge, double t, const Vec3& p, double depth) {
  ++m_counts->depthQueries;
  const double reach = m_edgeDepth + m_touching;
  const MovingSurface::Nearest nearest =
      !m_self ? side.surface->nearest(p, reach) : side.surface->nearestOf(p, reach, [&](int triangle, double squared) {
        return SelfRest::cameFromOutside(m_self->edgePointAndTriangle(edge, t, triangle), std::sqrt(squared));
      });
  if (nearest.triangle < 0 || !nearest.inside || nearest.distance < depth) return false;
  return !(side.owners->ofTriangle[nearest.triangle] & FeatureOwners::kSkipped);
}

}  // namespace glenoid
