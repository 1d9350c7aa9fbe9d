// SPDX-License-Identifier: GPL-3.0-or-later
// Overlaps so deep that nearest ways out contradict each other: what has passed the other's middle is nearest to the side that
// it must not leave by, and both are caught in each other for good. Such an overlap is undone along one direction for all of
// it, that in which its volume shrinks fastest: dV/dx = ∫ n dA over the part of a surface that lies in the other.
#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>

#include "simcore/collide/FeatureKey.h"
#include "simcore/collide/FeaturePoints.h"
#include "simcore/collide/PairSearch.h"

namespace glenoid {
namespace {

/// |∫ n dA| over the area, below which an overlap has no direction: what goes through the other from side to side.
constexpr double kOneWay = 0.1;
/// An overlap may be deep where this share of its area would leave against the common way, or so far across it (cosine) that it
/// would do so at several times the recovery speed.
constexpr double kAstray = 0.05, kAlong = 0.3;
/// All rows of an overlap ask for the same motion, so one for each bin across it is enough; their width over the thinner's
/// thickness.
constexpr double kBin = 0.5;

}  // namespace

void PairSearch::keepInside(Side& mine, int vertex, const Vec3& outward, bool glued) {
  if (m_self || mine.insideMark[vertex] == m_mark) return;
  mine.insideMark[vertex] = m_mark;
  mine.insideAt[vertex] = static_cast<int>(mine.inside.size());
  mine.inside.push_back({vertex, outward, Vec3::Zero(), 0, glued});
}

int PairSearch::overlapOf(int i) {
  while (m_overlapOf[i] != i) i = m_overlapOf[i] = m_overlapOf[m_overlapOf[i]];
  return i;
}

/// Vertices of both surfaces are of one overlap where edges or triangles that meet join them: a forest of unions over the inside
/// vertices of both, and after them the triangles.
void PairSearch::joinOverlaps() {
  m_overlapOf.resize(m_a.inside.size() + m_b.inside.size());
  std::iota(m_overlapOf.begin(), m_overlapOf.end(), 0);
  const auto unite = [&](int i, int j) {
    const int first = overlapOf(i), second = overlapOf(j);
    m_overlapOf[std::max(first, second)] = std::min(first, second);
  };
  for (const Side* side : {&m_a, &m_b}) {
    const CollisionSurface& surface = side->surface->topology();
    for (const Inside& inside : side->inside)
      for (const int e : surface.edgesOf(inside.vertex))
        for (const int end : surface.edges[e].vertices)
          if (side->insideMark[end] == m_mark) unite(insidePlace(*side, inside.vertex), insidePlace(*side, end));
  }
  // Triangles that meet are of an overlap even where none of their corners is inside.
  const auto placeOf = [this](Side& side, int t) {
    if (side.meetingMark[t] != m_mark) {
      side.meetingMark[t] = m_mark;
      side.meetingAt[t] = static_cast<int>(m_overlapOf.size());
      m_overlapOf.push_back(side.meetingAt[t]);
    }
    return side.meetingAt[t];
  };
  for (const auto& [ta, tb] : m_meeting) {
    const int here = placeOf(m_a, ta), there = placeOf(m_b, tb);
    unite(here, there);
    for (const auto& [side, t, place] : {std::tuple{&m_a, ta, here}, {&m_b, tb, there}})
      for (const int v : side->surface->topology().triangles[t])
        if (side->insideMark[v] == m_mark) unite(insidePlace(*side, v), place);
  }
}

/// Which way A goes out of B in each overlap, and how much of it would rather go another; true where one may be deep.
bool PairSearch::judgeOverlaps() {
  m_overlaps.assign(m_overlapOf.size(), {});
  const auto each = [&](auto&& visit) {
    for (Side* side : {&m_a, &m_b})
      for (Inside& inside : side->inside) visit(*side, inside, m_overlaps[overlapOf(insidePlace(*side, inside.vertex))]);
  };
  each([&](const Side& side, Inside& inside, Overlap& overlap) {
    const MovingSurface& surface = *side.surface;
    double area = 0;
    for (const int t : surface.topology().trianglesOf(inside.vertex)) {
      const auto& [i, j, k] = surface.topology().triangles[t];
      const Vec3 third = (surface.x(j) - surface.x(i)).cross(surface.x(k) - surface.x(i)) / 6;
      area += third.norm();
      inside.area_W += third;
    }
    inside.area = area;
    overlap.area += area;
    overlap.way += &side == &m_a ? Vec3(-inside.area_W) : inside.area_W;
    overlap.glued = overlap.glued || inside.glued;
  });
  for (Overlap& overlap : m_overlaps) {
    const double way = overlap.way.norm();
    overlap.deep = !overlap.glued && way > kOneWay * overlap.area;
    if (overlap.deep) overlap.way /= way;
  }
  each([&](const Side& side, const Inside& inside, Overlap& overlap) {
    if (overlap.deep && inside.outward.dot(overlap.way) * (&side == &m_a ? 1 : -1) < kAlong) overlap.astray += inside.area;
  });
  bool any = false;
  for (Overlap& overlap : m_overlaps) {
    overlap.deep = overlap.deep && overlap.astray > kAstray * overlap.area;
    any = any || overlap.deep;
  }
  return any;
}

/// The row of every vertex along its overlap's way; and which overlaps are so long along it that they are deep.
bool PairSearch::measureOverlaps(double least) {
  m_leaving.clear();
  for (const Side* side : {&m_a, &m_b}) {
    const Side& other = side == &m_a ? m_b : m_a;
    for (const Inside& inside : side->inside) {
      const int root = overlapOf(insidePlace(*side, inside.vertex));
      Overlap& overlap = m_overlaps[root];
      if (!overlap.deep) continue;
      const Vec3 way = side == &m_a ? overlap.way : Vec3(-overlap.way);
      const MovingSurface::Nearest out = other.surface->leaving(side->surface->x(inside.vertex), way, m_touching);
      if (out.triangle < 0 || other.owners->skipped(out.triangle)) continue;
      const double across = std::abs(inside.area_W.dot(overlap.way));
      overlap.across += across;
      overlap.volume += across * out.distance;
      Proximity row;
      row.pair = m_settings.pair;
      row.normal_W = overlap.way;
      row.gap = -out.distance;
      const FeaturePoint own = vertexPoint(inside.vertex), foot = trianglePoint(other.surface->topology().triangles[out.triangle], out.barycentric);
      row.a = side == &m_a ? own : foot;
      row.b = side == &m_a ? foot : own;
      row.key = vertexKey(*side, inside.vertex, out.feature);
      m_leaving.push_back({root, {}, side->surface->x(inside.vertex), row});
    }
  }
  bool any = false;
  for (Overlap& overlap : m_overlaps) {
    overlap.deep = overlap.deep && overlap.volume >= least * overlap.across && overlap.across > 0;
    any = any || overlap.deep;
  }
  return any;
}

/// Bins across the way of each overlap, laid out from its longest row towards what lies furthest from that: they turn with the scene.
void PairSearch::binRows(double width) {
  const auto longer = [](const Leaving& i, const Leaving& j) {
    if (i.root != j.root) return i.root < j.root;
    return i.row.gap != j.row.gap ? i.row.gap < j.row.gap : i.row.key < j.row.key;
  };
  std::sort(m_leaving.begin(), m_leaving.end(), longer);
  for (std::size_t first = 0, end = 0; first < m_leaving.size(); first = end) {
    while (end < m_leaving.size() && m_leaving[end].root == m_leaving[first].root) ++end;
    const Vec3 &way = m_overlaps[m_leaving[first].root].way, from = m_leaving[first].p_W;
    const auto aside = [&](const Vec3& p) { return Vec3(p - from - (p - from).dot(way) * way); };
    Vec3 across = Vec3::Zero();
    for (std::size_t i = first; i < end; ++i)
      if (const Vec3 at = aside(m_leaving[i].p_W); at.squaredNorm() > across.squaredNorm()) across = at;
    if (across.norm() > 0) across.normalize();
    const Vec3 along = way.cross(across);
    for (std::size_t i = first; i < end; ++i)
      for (int k = 0; k < 2; ++k)
        m_leaving[i].bin[k] = static_cast<long>(std::floor(aside(m_leaving[i].p_W).dot(k ? along : across) / width + 0.5));
  }
  std::sort(m_leaving.begin(), m_leaving.end(), [&](const Leaving& i, const Leaving& j) {
    if (i.root == j.root && i.bin != j.bin) return i.bin < j.bin;
    return longer(i, j);
  });
}

void PairSearch::partDeepOverlaps(std::size_t first) {
  if (m_a.inside.size() + m_b.inside.size() < 4 || !std::isfinite(m_limits.together)) return;
  joinOverlaps();
  const double thinner = std::min(m_a.surface->topology().thickness, m_b.surface->topology().thickness);
  if (!judgeOverlaps() || !measureOverlaps(m_limits.together * thinner)) return;
  const auto deepAt = [&](const Side& side, const FeaturePoint& point) {
    for (int k = 0; k < point.count; ++k)
      if (const int v = point.vertex[k]; side.insideMark[v] == m_mark && m_overlaps[overlapOf(insidePlace(side, v))].deep) return true;
    return false;
  };
  // Rows of nearest ways make room.
  const auto kept = std::remove_if(m_out->begin() + static_cast<std::ptrdiff_t>(first), m_out->end(), [&](const Proximity& row) {
    return row.gap < 0 && (deepAt(m_a, row.a) || deepAt(m_b, row.b));
  });
  m_out->erase(kept, m_out->end());
  binRows(kBin * thinner);
  for (std::size_t i = 0; i < m_leaving.size(); ++i) {
    const Leaving& leaving = m_leaving[i];
    if (!m_overlaps[leaving.root].deep) continue;
    if (i > 0 && m_leaving[i - 1].root == leaving.root && m_leaving[i - 1].bin == leaving.bin) continue;
    m_out->push_back(leaving.row);
  }
  for (const Overlap& overlap : m_overlaps) m_counts->deepOverlaps += overlap.deep;
}

}  // namespace glenoid
