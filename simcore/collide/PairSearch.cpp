// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/collide/PairSearch.h"

#include <algorithm>

#include "simcore/collide/FeaturePoints.h"
#include "simcore/collide/TriangleView.h"
#include "simcore/spatial/Intersect.h"

namespace glenoid {

void PairSearch::prepare(Side& side, MovingSurface& surface, const FeatureOwners& owners) {
  side.surface = &surface;
  side.owners = &owners;
  const std::size_t count = surface.topology().vertexCount;
  if (side.chain.size() < count) {
    side.chain.resize(count);
    side.chainMark.resize(count, 0);
    side.queueMark.resize(count, 0);
    side.queueWithin.resize(count);
    side.queue.reserve(count);
    side.insideMark.resize(count, 0);
    side.insideAt.resize(count);
    side.inside.reserve(count);
  }
  if (const std::size_t triangles = surface.topology().triangles.size(); side.meetingMark.size() < triangles) {
    side.meetingMark.resize(triangles, 0);
    side.meetingAt.resize(triangles);
  }
  side.queue.clear();
  side.inside.clear();
}

void PairSearch::run(const Settings& settings, MovingSurface& a, const FeatureOwners& ownersA,
                     MovingSurface& b, const FeatureOwners& ownersB, std::vector<Proximity>& out,
                     ProximityFinder::Counts& counts) {
  if (!a.usable() || !b.usable()) return;
  m_self = nullptr;
  m_settings = settings;
  m_ahead = a.ahead() + b.ahead();
  const BoxTree::Node &rootA = a.tree().nodes()[0], &rootB = b.tree().nodes()[0];
  const BoxTree::Sweep sweep = sweepOf(a, b);
  if (!BoxTree::overlap(rootA, sweep, rootB)) return;
  m_touching = kTouching * settings.contactDistance;
  m_shallow = kShallow * settings.contactDistance;
  m_edgeDepth = m_limits.edgeDepth * std::min(a.topology().thickness, b.topology().thickness);
  m_out = &out;
  m_counts = &counts;
  ++m_mark;
  prepare(m_a, a, ownersA);
  prepare(m_b, b, ownersB);
  m_meeting.clear();
  const std::size_t first = out.size();
  BoxTree::walkPairs(a.tree(), b.tree(), sweep, [this](int ta, int tb) { trianglePair(ta, tb); });

  // A surface that the other swallows whole meets no triangle; one vertex tells.
  const auto within = [](const BoxTree::Node& small, const BoxTree::Node& large) {
    bool yes = true;
    for (int k = 0; k < 3; ++k) yes &= small.low[k] >= large.low[k] && small.high[k] <= large.high[k];
    return yes;
  };
  if (ownersA.anyVertex >= 0 && within(rootA, rootB)) suspect(m_a, ownersA.anyVertex);
  if (ownersB.anyVertex >= 0 && within(rootB, rootA)) suspect(m_b, ownersB.anyVertex);
  followInside(m_a, m_b);
  followInside(m_b, m_a);
  partDeepOverlaps(first);
}

/// How far the drift of A against that of B carries it within the step, in any mixture of their motions. Boxes hold
/// what a surface does against its own drift only, so that what moves together is not near because it is fast.
BoxTree::Sweep PairSearch::sweepOf(const MovingSurface& a, const MovingSurface& b) {
  Vec3 low = Vec3::Zero(), high = Vec3::Zero();
  for (int i = 0; i < m_settings.motionCount; ++i)
    for (int j = 0; j < m_settings.motionCount; ++j) {
      const Vec3 way = m_settings.dt * (a.drift(i) - b.drift(j));
      low = low.cwiseMin(way);
      high = high.cwiseMax(way);
    }
  low = low.cwiseMax(-m_ahead);
  high = high.cwiseMin(m_ahead);
  m_swept = low.cwiseAbs().cwiseMax(high).norm();
  BoxTree::Sweep sweep;
  const float slack = m_swept > 0 ? 2 * std::max(a.laneSlack(), b.laneSlack()) : 0;
  for (int k = 0; k < 3; ++k) {
    sweep.low[k] = BoxTree::roundDown(low[k]) - slack;
    sweep.high[k] = BoxTree::roundUp(high[k]) + slack;
  }
  if (m_swept == 0) sweep = {};
  return sweep;
}

void PairSearch::trianglePair(int ta, int tb) {
  ++m_counts->trianglePairs;
  const std::uint8_t ownA = m_a.owners->ofTriangle[ta], ownB = m_b.owners->ofTriangle[tb];
  if ((ownA | ownB) & FeatureOwners::kSkipped) return;
  const MovingSurface &a = *m_a.surface, &b = *m_b.surface;
  const double margins = a.margin(ta) + b.margin(tb), reach = margins + m_swept, behind = std::max(m_edgeDepth, reach);

  // Most pairs end here, far apart although their boxes overlap, so they are asked in single precision first, with
  // thresholds that its errors cannot cross: is there a feature to try or can the triangles meet at all, and is one
  // wholly on one side of the other's plane and far from it?
  const float slack = 2 * std::max(a.laneSlack(), b.laneSlack());
  const MovingSurface::Bends &bendsA = a.bends(ta), &bendsB = b.bends(tb);
  const int convexA = ownA >> 3 & bendsA.convex, convexB = ownB >> 3 & bendsB.convex;
  const int softA = ownA >> 3 & bendsA.dentable, softB = ownB >> 3 & bendsB.dentable;
  // Of a part on itself two edges that are all but flat count as well: 0.06° of a bend, from which on one is convex, is
  // enough to sink in by a thousandth of its length, be pushed out flat, and sink in again.
  const int bothSoft = m_self ? softB : 0;
  const bool edges = (convexA && (convexB || softB)) || (softA && (convexB || bothSoft));
  const bool meetable = !boxesApart(a.tree().nodes()[a.tree().leafOf(ta)], b.tree().nodes()[b.tree().leafOf(tb)],
                                    static_cast<float>(margins) - slack);
  if (!meetable && !((ownA | ownB) & 7) && !edges) return;
  const float high = static_cast<float>(reach) + slack, low = static_cast<float>(behind) + slack;
  const PlaneView overB = viewOver(a.lanes(ta), b.lanes(tb), high, low, slack);
  if (overB.beyond()) return;
  const PlaneView overA = viewOver(b.lanes(tb), a.lanes(ta), high, low, slack);
  if (overA.beyond()) return;

  const auto &ia = a.topology().triangles[ta], &ib = b.topology().triangles[tb];
  Side &first = m_a, &second = m_self ? m_a : m_b, &facing = m_self ? m_b : m_a;  // of itself, vertices stand on the first side
  const int verticesA = ownA & 7 & overB.near, verticesB = ownB & 7 & overA.near;
  for (int k = 0; k < 3 && (verticesA | verticesB); ++k) {
    if ((verticesA >> k & 1) && std::abs(b.height(tb, a.x(ia[k]))) <= reach) vertexNearTriangle(first, m_b, ia[k], tb);
    if ((verticesB >> k & 1) && std::abs(a.height(ta, b.x(ib[k]))) <= reach) vertexNearTriangle(second, facing, ib[k], ta);
  }
  // The two sides of one layer lie wholly behind each other. If they have come there from outside their vertices say so.
  const bool behindEachOther = m_self && overB.below == 15 && overA.below == 15;
  for (int i = 0; i < 3 && edges && !behindEachOther; ++i) {
    const int partners = ((convexA >> i & 1) ? convexB | softB : 0) | ((softA >> i & 1) ? convexB | bothSoft : 0);
    const int ea = a.topology().triangleEdges[ta][i];
    for (int j = 0; j < 3; ++j)
      if (partners >> j & 1) edgeNearEdge(ea, b.topology().triangleEdges[tb][j]);
  }
  if (meetable && overB.crosses() && overA.crosses() && !(liesIn(a, ia, b, tb) && liesIn(b, ib, a, ta)) &&
      !(m_self && m_self->crossAtRest(ta, tb)) && trianglesMeet({a.x(ia[0]), a.x(ia[1]), a.x(ia[2])}, {b.x(ib[0]), b.x(ib[1]), b.x(ib[2])})) {
    if (!m_self) m_meeting.push_back({ta, tb});
    for (int k = 0; k < 3; ++k) {
      suspect(first, ia[k]);
      suspect(second, ib[k]);
    }
  }
}

/// Whether a triangle lies in another's plane to within what touches. Faces that rest on each other do; nothing of them is
/// inside, and exact predicates cost most where they say least.
bool PairSearch::liesIn(const MovingSurface& surface, const std::array<int, 3>& corners, const MovingSurface& plane, int t) const {
  return std::all_of(corners.begin(), corners.end(), [&](int v) { return std::abs(plane.height(t, surface.x(v))) <= m_touching; });
}

bool PairSearch::near(double distance, double gap, const Vec3& normal, const MovingSurface& first, const FeaturePoint& a,
                      const MovingSurface& second, const FeaturePoint& b) const {
  if (gap < distance) return true;
  if (m_self) {  // both follow the same motion
    double closing = 0;
    for (int motion = 0; motion < m_settings.motionCount; ++motion)
      closing = std::max(closing, normal.dot(velocityOf(second, motion, b) - velocityOf(first, motion, a)));
    return gap < distance + std::min(closing * m_settings.dt, m_ahead);
  }
  // Each side may follow another motion, so the most of one adds to the most of the other.
  double closingA = 0, closingB = 0;
  for (int motion = 0; motion < m_settings.motionCount; ++motion) {
    const double ofA = -normal.dot(velocityOf(first, motion, a)), ofB = normal.dot(velocityOf(second, motion, b));
    closingA = motion == 0 ? ofA : std::max(closingA, ofA);
    closingB = motion == 0 ? ofB : std::max(closingB, ofB);
  }
  const double ahead = (closingA + closingB) * m_settings.dt;
  return gap < distance + std::clamp(ahead, 0.0, m_ahead);
}

}  // namespace glenoid
