// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices that are near faces, edges and vertices of the other surface, from outside or touching.
#include <algorithm>

#include "simcore/collide/FeatureKey.h"
#include "simcore/collide/FeaturePoints.h"
#include "simcore/collide/PairSearch.h"
#include "simcore/spatial/TrianglePoint.h"

namespace glenoid {
namespace {

/// Share of what touches within which two feet of one vertex are the same contact on two features.
constexpr double kSameFoot = 10;
/// Rounding of the sines that the Voronoi test takes.
constexpr double kRounding = 1e-9;
/// Sine of the angle by which two faces must rise toward each other to make a valley.
constexpr double kValley = 1e-3;

bool isValley(const MovingSurface& surface, int e) {
  const CollisionSurface::Edge& edge = surface.topology().edges[e];
  if (edge.triangles[1] < 0) return false;
  const Vec3 away = surface.x(edge.opposite[1]) - surface.x(edge.vertices[0]);
  return surface.faceNormal(edge.triangles[0]).dot(away) > kValley * away.norm();
}

/// Whether a·b is above a sine times both lengths.
bool leans(const Vec3& a, const Vec3& b, double sine) {
  const double along = a.dot(b);
  return along > 0 && along * along > sine * sine * a.squaredNorm() * b.squaredNorm();
}

}  // namespace

/// Whether no point of the surface beside the feature is nearer than the foot, `away` being the way from it.
bool PairSearch::nearestLocally(const Side& side, const MovingSurface::Feature& feature, const Vec3& foot,
                                const Vec3& away) const {
  const MovingSurface& surface = *side.surface;
  const CollisionSurface& s = surface.topology();
  if (feature.kind == FeatureKind::Edge) {
    const CollisionSurface::Edge& edge = s.edges[feature.id];
    for (int k = 0; k < 2; ++k)
      if (edge.triangles[k] >= 0 && !side.owners->skipped(edge.triangles[k]) &&
          leans(away, surface.x(edge.opposite[k]) - foot, kRounding))
        return false;
  } else if (feature.kind == FeatureKind::Vertex) {
    for (const int e : s.edgesOf(feature.id)) {
      if (!side.owners->edgeTakesPart[e]) continue;
      const auto& ends = s.edges[e].vertices;
      if (leans(away, surface.x(ends[0] == feature.id ? ends[1] : ends[0]) - foot, kRounding)) return false;
    }
  }
  return true;
}

bool PairSearch::facesItself(Side& mine, Side& other, int vertex, int triangle, const Vec3& outward) {
  MovingSurface& surface = *mine.surface;
  const Vec3& normal = surface.vertexNormal(vertex);
  const double looks = outward.dot(normal);
  if (looks > 0 && looks * looks > kWidened * kWidened * normal.squaredNorm()) return false;
  const Vec3& x = surface.x(vertex);
  double turn = -1;  // by how much the other's triangle may turn within the step, rad; worked out when it matters
  for (const int e : surface.topology().edgesOf(vertex)) {
    if (!mine.owners->edgeTakesPart[e]) continue;
    const auto& ends = surface.topology().edges[e].vertices;
    const int y = ends[0] == vertex ? ends[1] : ends[0];
    const Vec3 way = surface.x(y) - x;
    const double rise = outward.dot(way);
    if (rise >= 0 || rise * rise <= kWidened * kWidened * way.squaredNorm()) continue;
    // The neighbour lies nearer. It may not do so any more at the end of the step, if it or the other's triangle turns.
    const MovingSurface& facing = *other.surface;
    double change = 0;
    for (int motion = 0; motion < m_settings.motionCount; ++motion)
      change = std::max(change, m_settings.dt * outward.dot(surface.v(motion, y) - surface.v(motion, vertex)));
    if (turn < 0) {
      turn = 0;
      const auto& corners = facing.topology().triangles[triangle];
      for (int motion = 0; motion < m_settings.motionCount; ++motion)
        for (int k = 0; k < 3; ++k) {
          const int i = corners[k], j = corners[(k + 1) % 3];
          const double lift = m_settings.dt * std::abs(outward.dot(facing.v(motion, j) - facing.v(motion, i)));
          if (lift > 0) turn = std::max(turn, lift / (facing.x(j) - facing.x(i)).norm());
        }
    }
    if (rise + change < -(kWidened + turn) * way.norm()) return false;
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
    if (gap < -m_touching) {
      if (mayBeInside(vertex, triangle, -gap)) suspect(mine, vertex);
      return;
    }
    return emitVertex(mine, other, vertex, triangle, w, feature, surface.faceNormal(triangle), gap);
  }
  const Vec3 foot = w[0] * surface.x(i) + w[1] * surface.x(j) + w[2] * surface.x(k);
  const Vec3 away = p - foot;
  const double distance = away.norm();
  if (distance > m_settings.contactDistance + m_ahead) return;
  const std::uint8_t own = other.owners->ofTriangle[triangle];
  const auto& corners = surface.topology().triangles[triangle];
  const auto& sides = surface.topology().triangleEdges[triangle];
  const auto& ids = feature.kind == FeatureKind::Edge ? sides : corners;
  const int place = ids[0] == feature.id ? 0 : (ids[1] == feature.id ? 1 : 2);
  if (!(own >> (place + (feature.kind == FeatureKind::Edge ? 3 : 0)) & 1)) return;
  if (distance < m_touching) return vertexTouches(mine, other, vertex, triangle, w, feature, away);
  if (!nearestLocally(other, feature, foot, away)) {
    const bool ridge = feature.kind == FeatureKind::Edge && surface.bend(feature.id) == MovingSurface::Bend::Convex;
    if (ridge && distance < m_shallow) vertexTouches(mine, other, vertex, triangle, w, feature, away);
    return;
  }
  if (away.dot(surface.normalOf(feature)) < 0) {
    if (mayBeInside(vertex, triangle, distance)) suspect(mine, vertex);
    return;
  }
  emitVertex(mine, other, vertex, triangle, w, feature, away / distance, distance);
}

/// On an edge or a vertex of the other surface, to within rounding: the direction is one that both features allow.
void PairSearch::vertexTouches(Side& mine, Side& other, int vertex, int triangle, const Vec3& barycentric,
                               const MovingSurface::Feature& feature, const Vec3& apart) {
  m_cone.take(*other.surface, feature, *other.owners);
  m_against.take(*mine.surface, {FeatureKind::Vertex, vertex}, *mine.owners);
  const Vec3* last = lastNormal(vertexKey(mine, vertex, feature));
  const Vec3 before = last ? Vec3(isFirst(mine, vertex, feature) ? *last : -*last) : Vec3();
  const std::optional<Vec3> outward = sharedNormal(m_cone, m_against, kWidened, kOverlapped, last ? &before : nullptr);
  if (outward) emitVertex(mine, other, vertex, triangle, barycentric, feature, *outward, outward->dot(apart));
}

std::uint64_t PairSearch::vertexKey(const Side& mine, int vertex, const MovingSurface::Feature& feature) const {
  return isFirst(mine, vertex, feature) ? FeatureKey::make(m_settings.pair, FeatureKind::Vertex, vertex, feature.kind, feature.id)
                                        : FeatureKey::make(m_settings.pair, feature.kind, feature.id, FeatureKind::Vertex, vertex);
}

const Vec3* PairSearch::lastNormal(std::uint64_t key) const {
  const auto found = std::lower_bound(m_settings.last.begin(), m_settings.last.end(), key,
                                      [](const LastNormal& known, std::uint64_t wanted) { return known.key < wanted; });
  return found != m_settings.last.end() && found->key == key ? &found->normal_W : nullptr;
}

/// Outside or touching a face: the vertex must be near and nearest of its own surface. Touching an edge or a vertex: the
/// direction says that already. Inside: always.
void PairSearch::emitVertex(Side& mine, Side& other, int vertex, int triangle, const Vec3& barycentric,
                            const MovingSurface::Feature& feature, const Vec3& outward, double gap) {
  const bool first = isFirst(mine, vertex, feature);
  Proximity contact;
  contact.pair = m_settings.pair;
  FeaturePoint& own = first ? contact.a : contact.b;
  FeaturePoint& foot = first ? contact.b : contact.a;
  own = vertexPoint(vertex);
  foot = trianglePoint(other.surface->topology().triangles[triangle], barycentric);
  contact.normal_W = first ? outward : Vec3(-outward);
  contact.gap = gap;
  if (sameCell(own, foot)) return;
  if (gap >= m_touching || (feature.kind == FeatureKind::Face && gap >= -m_touching)) {
    if (!near(m_settings.contactDistance, gap, outward, *mine.surface, own, *other.surface, foot)) return;
    if (m_self && !near(distanceOf(vertex, triangle), gap, outward, *mine.surface, own, *other.surface, foot)) return;
    if (!facesItself(mine, other, vertex, triangle, outward)) return;
  }
  contact.key = vertexKey(mine, vertex, feature);

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
  const double same = kSameFoot * m_touching;
  for (int i = mine.chain[vertex]; i >= 0; i = m_next[i]) {
    Proximity& known = (*m_out)[i];
    const bool knownFirst = m_self ? known.a.count == 1 && known.a.vertex[0] == vertex : first;
    if ((footPosition(knownFirst ? known.b : known.a) - here).squaredNorm() > same * same) continue;
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
  if (m_self && (m_self->share(vertex, triangle) || (gap < 0 && !mayBeInside(vertex, triangle, -gap)))) return;
  if (m_self && gap < -m_touching && !covered(vertex)) return;
  if (sameCell(vertexPoint(vertex), foot)) return;
  double slide = 0;
  for (int motion = 0; motion < m_settings.motionCount; ++motion)
    slide = std::max(slide, m_settings.dt * (mine.surface->v(motion, vertex) - velocityOf(surface, motion, foot)).norm());
  const double reach = m_settings.contactDistance + std::min(slide, m_ahead);
  // Sliding brings the vertex nearer to the plane by the sine of their angle at most.
  if (gap > reach * sine || gap < -m_limits.depth * surface.topology().thickness) return;
  const Vec3 to = w[0] * surface.x(i) + w[1] * surface.x(j) + w[2] * surface.x(k);
  if ((p - to).squaredNorm() > reach * reach + gap * gap) return;
  if (!facesItself(mine, other, vertex, triangle, n)) return;
  Proximity contact;
  contact.pair = m_settings.pair;
  contact.gap = gap;
  const bool first = &mine == &m_a;
  contact.normal_W = first ? n : Vec3(-n);
  (first ? contact.a : contact.b) = vertexPoint(vertex);
  (first ? contact.b : contact.a) = foot;
  contact.key = vertexKey(mine, vertex, {FeatureKind::Face, triangle});
  m_next.resize(m_out->size() + 1);
  m_next[m_out->size()] = -1;
  m_out->push_back(contact);
}

}  // namespace glenoid
