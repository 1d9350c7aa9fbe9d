// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices near faces, edges and vertices of the other surface, and those inside it.
#include <algorithm>

#include "simcore/collide/FeatureKey.h"
#include "simcore/collide/FeaturePoints.h"
#include "simcore/collide/PairSearch.h"
#include "simcore/spatial/TrianglePoint.h"

namespace glenoid {
namespace {

/// Two constraints of one vertex whose feet are nearer than this are the same contact on two features. m.
constexpr double kSameFoot = 1e-6;
/// Slack of the Voronoi test, m²: far below (edge length) × (contact distance), far above rounding.
constexpr double kVoronoiSlack = 1e-12;
/// A vertex whose own normal points along the contact normal more than this lies on the far side of its body.
constexpr double kFarSide = 0.5;
/// Sine of the angle by which two faces must rise toward each other to make a valley.
constexpr double kValley = 1e-3;

bool isValley(const MovingSurface& surface, int e) {
  const CollisionSurface::Edge& edge = surface.topology().edges[e];
  if (edge.triangles[1] < 0) return false;
  const Vec3 away = surface.x(edge.opposite[1]) - surface.x(edge.vertices[0]);
  return surface.faceNormal(edge.triangles[0]).dot(away) > kValley * away.norm();
}

}  // namespace

/// Whether no point of the surface beside the feature is nearer than the foot, `away` being the way from it.
bool PairSearch::nearestLocally(const MovingSurface& surface, const MovingSurface::Feature& feature,
                                const Vec3& foot, const Vec3& away) const {
  const CollisionSurface& s = surface.topology();
  if (feature.kind == FeatureKind::Edge) {
    for (const int v : s.edges[feature.id].opposite) {
      if (v >= 0 && away.dot(surface.x(v) - foot) > kVoronoiSlack) return false;
    }
  } else if (feature.kind == FeatureKind::Vertex) {
    for (const int e : s.edgesOf(feature.id)) {
      const auto& ends = s.edges[e].vertices;
      const int v = ends[0] == feature.id ? ends[1] : ends[0];
      if (away.dot(surface.x(v) - foot) > kVoronoiSlack) return false;
    }
  }
  return true;
}

void PairSearch::vertexNearTriangle(Side& mine, Side& other, int vertex, int triangle) {
  ++m_counts->vertexFace;
  MovingSurface& surface = *other.surface;
  if (!surface.hasFace(triangle)) return;
  const Vec3& p = mine.surface->x(vertex);
  const auto [i, j, k] = surface.topology().triangles[triangle];
  const Vec3 w = nearestBarycentric(p, surface.x(i), surface.x(j), surface.x(k));
  const MovingSurface::Feature feature = surface.featureOf(triangle, w);
  if (feature.kind == FeatureKind::Face) {
    const double gap = surface.height(triangle, p);
    if (gap < 0) return suspect(mine, vertex);
    return emitVertex(mine, other, vertex, triangle, w, feature, surface.faceNormal(triangle), gap);
  }
  const Vec3 foot = w[0] * surface.x(i) + w[1] * surface.x(j) + w[2] * surface.x(k);
  const Vec3 away = p - foot;
  const double distance = away.norm();
  if (distance > m_settings.contactDistance + m_limits.lookAhead) return;
  const std::uint8_t own = other.owners->ofTriangle[triangle];
  const auto& corners = surface.topology().triangles[triangle];
  const auto& sides = surface.topology().triangleEdges[triangle];
  const auto& ids = feature.kind == FeatureKind::Edge ? sides : corners;
  const int place = ids[0] == feature.id ? 0 : (ids[1] == feature.id ? 1 : 2);
  if (!(own >> (place + (feature.kind == FeatureKind::Edge ? 3 : 0)) & 1)) return;
  if (!nearestLocally(surface, feature, foot, away)) return;
  const Vec3 pseudo = surface.normalOf(feature);
  if (distance < kTouching) {
    if (pseudo.isZero(0)) return;
    return emitVertex(mine, other, vertex, triangle, w, feature, pseudo.stableNormalized(), 0);
  }
  if (away.dot(pseudo) < 0) return suspect(mine, vertex);
  emitVertex(mine, other, vertex, triangle, w, feature, away / distance, distance);
}

/// Outside: the vertex must be near and not on the far side of its own body. Inside (gap < 0): always.
void PairSearch::emitVertex(Side& mine, Side& other, int vertex, int triangle, const Vec3& barycentric,
                            const MovingSurface::Feature& feature, const Vec3& outward, double gap) {
  const bool first = &mine == &m_a;
  Proximity contact;
  contact.pair = m_settings.pair;
  FeaturePoint& own = first ? contact.a : contact.b;
  FeaturePoint& foot = first ? contact.b : contact.a;
  own = vertexPoint(vertex);
  foot = trianglePoint(other.surface->topology().triangles[triangle], barycentric);
  contact.normal_W = first ? outward : Vec3(-outward);
  contact.gap = gap;
  if (gap >= 0) {
    if (!near(gap, outward, *mine.surface, own, *other.surface, foot)) return;
    const Vec3& normal = mine.surface->vertexNormal(vertex);
    if (normal.dot(outward) > kFarSide * normal.norm()) return;
  }
  contact.key =
      first ? FeatureKey::make(m_settings.pair, FeatureKind::Vertex, vertex, feature.kind, feature.id)
            : FeatureKey::make(m_settings.pair, feature.kind, feature.id, FeatureKind::Vertex, vertex);

  if (feature.kind == FeatureKind::Edge && isValley(*other.surface, feature.id)) {
    // At the bottom of a valley the direction to the edge is that of neither face, and rounding if they touch.
    for (const int t : other.surface->topology().edges[feature.id].triangles) emitPlane(mine, other, vertex, t, 1);
    return;
  }
  if (feature.kind == FeatureKind::Face) acrossValleys(mine, other, vertex, triangle);

  // Where faces meet almost flat, rounding lets two features claim the same foot: the lower key stays.
  if (mine.chainMark[vertex] != m_mark) {
    mine.chainMark[vertex] = m_mark;
    mine.chain[vertex] = -1;
  }
  const auto footPosition = [&](const FeaturePoint& point) {
    Vec3 x = Vec3::Zero();
    for (int k = 0; k < point.count; ++k) x += point.weight[k] * other.surface->x(point.vertex[k]);
    return x;
  };
  const Vec3 here = footPosition(foot);
  for (int i = mine.chain[vertex]; i >= 0; i = m_next[i]) {
    Proximity& known = (*m_out)[i];
    if ((footPosition(first ? known.b : known.a) - here).squaredNorm() > kSameFoot * kSameFoot) continue;
    if (contact.key < known.key) known = contact;
    return;
  }
  m_next.resize(m_out->size() + 1);
  m_next[m_out->size()] = mine.chain[vertex];
  mine.chain[vertex] = static_cast<int>(m_out->size());
  m_out->push_back(contact);
}

/// Beside a concave edge the outside is what lies in front of both faces, so a vertex that touches one of them and
/// may slide to the edge within the step needs the other's plane as well; with one at a time it would swing between
/// them, always inside the one that was left out.
void PairSearch::acrossValleys(Side& mine, Side& other, int vertex, int triangle) {
  const MovingSurface& surface = *other.surface;
  for (const int e : surface.topology().triangleEdges[triangle]) {
    if (!isValley(surface, e)) continue;
    const auto& triangles = surface.topology().edges[e].triangles;
    const int beside = triangles[triangles[0] == triangle ? 1 : 0];
    const double sine = surface.faceNormal(triangle).cross(surface.faceNormal(beside)).norm();
    emitPlane(mine, other, vertex, beside, sine);
  }
}

/// The plane of a face as seen from a vertex whose foot may lie at the face's edge. `sine`: of the angle between
/// the plane that the vertex slides along and this one.
void PairSearch::emitPlane(Side& mine, Side& other, int vertex, int triangle, double sine) {
  if (other.owners->ofTriangle[triangle] & FeatureOwners::kSkipped) return;
  const MovingSurface& surface = *other.surface;
  const Vec3 &p = mine.surface->x(vertex), &n = surface.faceNormal(triangle);
  const auto& corners = surface.topology().triangles[triangle];
  const auto [i, j, k] = corners;
  const Vec3 w = nearestBarycentric(p, surface.x(i), surface.x(j), surface.x(k));
  const FeaturePoint foot{3, corners, {w[0], w[1], w[2]}};
  const double gap = surface.height(triangle, p);
  double slide = 0;
  for (int motion = 0; motion < m_settings.motionCount; ++motion)
    slide = std::max(slide, m_settings.dt * (mine.surface->v(motion, vertex) - velocityOf(surface, motion, foot)).norm());
  const double reach = m_settings.contactDistance + std::min(slide, m_limits.lookAhead);
  // Sliding brings the vertex nearer to the plane by the sine of their angle at most.
  if (gap > reach * sine || gap < -m_limits.depth) return;
  const Vec3 to = w[0] * surface.x(i) + w[1] * surface.x(j) + w[2] * surface.x(k);
  if ((p - to).squaredNorm() > reach * reach + gap * gap) return;
  const Vec3& own = mine.surface->vertexNormal(vertex);
  if (own.dot(n) > kFarSide * own.norm()) return;
  const bool first = &mine == &m_a;
  Proximity contact;
  contact.pair = m_settings.pair;
  contact.gap = gap;
  contact.normal_W = first ? n : Vec3(-n);
  (first ? contact.a : contact.b) = vertexPoint(vertex);
  (first ? contact.b : contact.a) = foot;
  contact.key = first ? FeatureKey::make(m_settings.pair, FeatureKind::Vertex, vertex, FeatureKind::Face, triangle)
                      : FeatureKey::make(m_settings.pair, FeatureKind::Face, triangle, FeatureKind::Vertex, vertex);
  m_next.resize(m_out->size() + 1);
  m_next[m_out->size()] = -1;
  m_out->push_back(contact);
}

void PairSearch::suspect(Side& mine, int vertex) {
  if (mine.queueMark[vertex] == m_mark) return;
  mine.queueMark[vertex] = m_mark;
  mine.queue.push_back(vertex);
}

/// From the vertices where the surfaces meet along the edges to all that are inside: each is pushed out
/// through the nearest face.
void PairSearch::followInside(Side& mine, Side& other) {
  MovingSurface& surface = *other.surface;
  for (std::size_t i = 0; i < mine.queue.size(); ++i) {
    const int vertex = mine.queue[i];
    if (!mine.owners->vertexTakesPart[vertex]) continue;
    const Vec3& p = mine.surface->x(vertex);
    ++m_counts->depthQueries;
    MovingSurface::Nearest nearest = surface.nearest(p, m_limits.depth);
    if (nearest.triangle < 0 || !nearest.inside) continue;
    for (const int e : mine.surface->topology().edgesOf(vertex)) {
      const auto& ends = mine.surface->topology().edges[e].vertices;
      suspect(mine, ends[0] == vertex ? ends[1] : ends[0]);
    }

    // In a thin sheet the far face may be nearer; a face that looks at the vertex's own side goes before it.
    const auto outwardOf = [&](const MovingSurface::Nearest& found) -> Vec3 {
      if (found.feature.kind == FeatureKind::Face) return surface.faceNormal(found.triangle);
      const Vec3 way = found.point - p;
      return found.distance > kTouching ? Vec3(way / found.distance)
                                        : Vec3(surface.normalOf(found.feature).stableNormalized());
    };
    Vec3 outward = outwardOf(nearest);
    const Vec3 own = mine.surface->vertexNormal(vertex).stableNormalized();
    if (own.dot(outward) > kFarSide && nearest.distance > kTouching) {
      ++m_counts->depthQueries;
      const double reach = std::min(m_limits.depth, 3 * nearest.distance);
      const MovingSurface::Nearest facing = surface.nearestFacing(p, reach, own, -0.2);
      if (facing.triangle >= 0) {
        nearest = facing;
        outward = surface.faceNormal(facing.triangle);
      }
    }
    if (other.owners->ofTriangle[nearest.triangle] & FeatureOwners::kSkipped) continue;
    if (outward.isZero(0)) continue;
    emitVertex(mine, other, vertex, nearest.triangle, nearest.barycentric, nearest.feature, outward,
               -nearest.distance);
  }
}

}  // namespace glenoid
