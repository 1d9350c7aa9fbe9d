// SPDX-License-Identifier: GPL-3.0-or-later
// Vertices that are inside the other surface, and the way out that their own surface allows.
#include <algorithm>
#include <cmath>

#include "simcore/collide/PairSearch.h"

namespace glenoid {
namespace {

/// How many times as far as the nearest way out, or the contact distance, an allowed one may be: what is swallowed whole
/// has to leave by one side.
constexpr double kOtherWay = 3;
/// Covers the rounding of a sum of distances.
constexpr double kRounded = 1 + 1e-9;

}  // namespace

void PairSearch::suspect(Side& mine, int vertex, double within) {
  if (mine.queueMark[vertex] == m_mark) return;
  mine.queueMark[vertex] = m_mark;
  mine.queue.push_back(vertex);
  mine.queueWithin[vertex] = within;
}

void PairSearch::takeCone(Side& mine, int vertex) {
  MovingSurface& surface = *mine.surface;
  m_coneNormal = surface.vertexNormal(vertex).stableNormalized();
  m_coneWays.clear();
  for (const int e : surface.topology().edgesOf(vertex)) {
    if (!mine.owners->edgeTakesPart[e]) continue;
    const auto& ends = surface.topology().edges[e].vertices;
    const Vec3 way = surface.x(ends[0] == vertex ? ends[1] : ends[0]) - surface.x(vertex);
    if (const double length = way.norm(); length > 0) m_coneWays.push_back({way, length});
  }
}

/// Whether −outward lies outside the normal cone of the vertex taken last, widened.
bool PairSearch::leavesCone(const Vec3& outward) const {
  if (outward.dot(m_coneNormal) > kOverlapped) return true;
  return std::any_of(m_coneWays.begin(), m_coneWays.end(), [&](const auto& way) { return -outward.dot(way.first) / way.second > kOverlapped; });
}

/// From the vertices where the surfaces meet along the edges to all that are inside. Each is pushed out the nearest way
/// that its own surface allows: through a face that its normal cone, widened, looks at. That is neither the side of a box
/// on which its corner stands, nor the far side of a sheet. Where nothing is allowed, as at a concave vertex in a dent,
/// the nearest way it is.
void PairSearch::followInside(Side& mine, Side& other) {
  MovingSurface& surface = *other.surface;
  const double reach = m_limits.depth * surface.topology().thickness;
  for (std::size_t i = 0; i < mine.queue.size(); ++i) {
    const int vertex = mine.queue[i];
    if (!mine.owners->vertexTakesPart[vertex]) continue;
    if (m_self && !covered(vertex)) continue;  // a ray, against a search among triangles of which few count
    const Vec3& p = mine.surface->x(vertex);
    ++m_counts->depthQueries;
    MovingSurface::Nearest nearest = nearestTo(other, vertex, p, std::min(reach, mine.queueWithin[vertex]));
    if (nearest.triangle < 0) continue;
    const bool touches = nearest.distance < m_touching;
    if (!nearest.inside && !touches) continue;
    bool glued = false;  // reaches what takes no part
    if (nearest.inside)
      for (const int e : mine.surface->topology().edgesOf(vertex)) {
        const auto& ends = mine.surface->topology().edges[e].vertices;
        const int neighbour = ends[0] == vertex ? ends[1] : ends[0];
        glued = glued || !mine.owners->vertexTakesPart[neighbour];
        // No further than by way of this vertex: from deep inside, a bound saves most of the search. Of one surface other triangles
        // count for each vertex.
        suspect(mine, neighbour, m_self ? kAnyDistance : kRounded * (nearest.distance + (mine.surface->x(neighbour) - p).norm()) + m_touching);
      }

    Vec3 outward = nearest.feature.kind == FeatureKind::Face ? surface.faceNormal(nearest.triangle)
                   : touches                                 ? Vec3(surface.normalOf(nearest.feature).stableNormalized())
                                                             : Vec3((nearest.point - p) / nearest.distance);
    takeCone(mine, vertex);
    if (outward.isZero(0) || leavesCone(outward)) {
      ++m_counts->depthQueries;
      const auto allowed = [&](const Vec3& normal, int t, double depth2) {
        return (!m_self || mayBeInside(vertex, t, std::sqrt(depth2))) && !leavesCone(normal);
      };
      const double further = std::min(reach, std::max(kOtherWay * nearest.distance, m_settings.contactDistance));
      const MovingSurface::Nearest facing = surface.nearestFace(p, further, m_touching, allowed);
      if (facing.triangle >= 0) {
        nearest = facing;
        outward = surface.faceNormal(facing.triangle);
      } else if (touches) {
        continue;
      }
    } else if (touches) {
      continue;  // found by what it touches
    }
    const bool skipped = other.owners->skipped(nearest.triangle);
    keepInside(mine, vertex, outward, glued || skipped);
    if (skipped || outward.isZero(0)) continue;
    emitVertex(mine, other, vertex, nearest.triangle, nearest.barycentric, nearest.feature, outward, -nearest.distance);
  }
}

}  // namespace glenoid
