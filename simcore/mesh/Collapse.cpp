// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/mesh/Collapse.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>

namespace glenoid {
namespace {

/// Weight of the points against the planes. In the cost it orders the collapses within a plane and favours
/// patches of even size; where the vertex goes it only decides what the planes leave open, since a patch's
/// points would draw a thin rim inwards.
constexpr double kSpreadInCost = 4e-3, kSpreadInPlace = 3e-4;

/// The vertex keeps the volume where its error is at most this many times the least one.
constexpr double kVolumeWorth = 2;

constexpr int kPlaces = 5;
constexpr double kSliver = 0.1;

/// Cutting is tested against every other triangle; above this number coarse errors are not yet possible.
constexpr int kCutTestBelow = 6000;
constexpr double kCutTolerance = 1e-9;  // of the diagonal

Vec3 areaVector(const Triangle3& t) {
  return (t[1] - t[0]).cross(t[2] - t[0]) / 2;
}

double shapeOf(const Triangle3& t) {
  const double squares =
      (t[1] - t[0]).squaredNorm() + (t[2] - t[1]).squaredNorm() + (t[0] - t[2]).squaredNorm();
  return squares > 0 ? 4 * std::sqrt(3.0) * areaVector(t).norm() / squares : 0;
}

Box3 boxOf(const Triangle3& t) {
  Box3 box(t[0]);
  return box.extend(t[1]).extend(t[2]);
}

bool contains(const std::array<int, 3>& t, int v) {
  return t[0] == v || t[1] == v || t[2] == v;
}

double cosine(const Vec3& a, const Vec3& b) {
  const double lengths = a.norm() * b.norm();
  return lengths > 0 ? a.dot(b) / lengths : 1;
}

}  // namespace

void Quadric::addPlane(const Vec3& normal, const Vec3& point, double weight) {
  const double d = normal.dot(point);
  A += weight * normal * normal.transpose();
  b += weight * d * normal;
  c += weight * d * d;
}

void Quadric::addPoint(const Vec3& point, double weight) {
  A.diagonal().array() += weight;
  b += weight * point;
  c += weight * point.squaredNorm();
}

Quadric& Quadric::operator+=(const Quadric& o) {
  A += o.A, b += o.b, c += o.c;
  return *this;
}

Collapser::Collapser(const TriMesh& mesh, const std::vector<double>& importance)
    : m_triangles(mesh.triangles), m_alive(static_cast<int>(mesh.triangles.size())) {
  const Box3 box = boundsOf(mesh);
  m_centre = box.center();
  m_scale = std::max(box.diagonal().norm(), std::numeric_limits<double>::min());
  for (const Vec3& v : mesh.vertices) m_points.push_back((v - m_centre) / m_scale);
  m_dead.assign(m_triangles.size(), 0);
  m_fans.resize(m_points.size());
  m_stamps.assign(m_points.size(), 0);
  m_importance = importance;
  m_importance.resize(m_points.size(), 1);
  m_planes.resize(m_points.size());
  m_spread.resize(m_points.size());
  for (int t = 0; t < m_alive; ++t) {
    const Triangle3 c = corners(t);
    const Vec3 vector = areaVector(c);
    const double area = vector.norm();
    m_wanted += c[0].dot(c[1].cross(c[2]));
    m_liveList.push_back(t);
    for (int i = 0; i < 3; ++i) {
      m_fans[m_triangles[t][i]].push_back(t);
      if (area > 0) m_planes[m_triangles[t][i]].addPlane(vector / area, c[0], area / 3);
      m_spread[m_triangles[t][i]].addPoint(c[i], area / 3);
    }
  }
}

Triangle3 Collapser::corners(int triangle) const {
  const auto& t = m_triangles[triangle];
  return {m_points[t[0]], m_points[t[1]], m_points[t[2]]};
}

Triangle3 Collapser::cornersAfter(int triangle, int u, int v, const Vec3& at) const {
  Triangle3 c;
  for (int i = 0; i < 3; ++i) {
    const int w = m_triangles[triangle][i];
    c[i] = w == u || w == v ? at : m_points[w];
  }
  return c;
}

std::vector<int> Collapser::neighbours(int v) const {
  std::vector<int> ring;
  for (const int t : m_fans[v])
    for (const int w : m_triangles[t])
      if (w != v) ring.push_back(w);
  std::sort(ring.begin(), ring.end());
  ring.erase(std::unique(ring.begin(), ring.end()), ring.end());
  return ring;
}

Collapser::Candidate Collapser::candidate(int u, int v, int rank) const {
  Quadric planes = m_planes[u], spread = m_spread[u];
  planes += m_planes[v], spread += m_spread[v];
  const auto cost = [&](const Vec3& x) { return planes.error(x) + kSpreadInCost * spread.error(x); };
  const Mat3 A = planes.A + kSpreadInPlace * spread.A;
  const Vec3 b = planes.b + kSpreadInPlace * spread.b;
  const Vec3 middle = (m_points[u] + m_points[v]) / 2;
  const double length = (m_points[u] - m_points[v]).norm();
  // Six times the volume under the patch is linear in the new vertex: g·x, and `now` before the collapse.
  // Taken from the middle of the edge to keep digits.
  Vec3 g = Vec3::Zero();
  double now = 0;
  for (const int w : {u, v})
    for (const int t : m_fans[w]) {
      const auto& c = m_triangles[t];
      const bool dies = contains(c, u) && contains(c, v);
      if (dies && w == v) continue;
      const Vec3 p = m_points[c[0]] - middle, q = m_points[c[1]] - middle, r = m_points[c[2]] - middle;
      now += p.dot(q.cross(r));
      if (!dies) g += c[0] == w ? q.cross(r) : c[1] == w ? r.cross(p) : p.cross(q);
    }
  const auto near = [&](const Vec3& x) { return x.allFinite() && (x - middle).norm() <= 1.5 * length; };
  const double trace = A.trace();
  // Places in order of preference; later ones are tried when the rules refuse the first.
  struct PlaceForVertex {
    double cost;
    Vec3 at;
  };
  std::array<PlaceForVertex, kPlaces> places;
  int count = 0;
  for (const Vec3& p : {middle, m_points[u], m_points[v]}) places[count++] = {cost(p), p};
  if (trace > 0 && A.determinant() > 1e-12 * trace * trace * trace) {
    const Mat3 inverse = A.inverse();
    const Vec3 least = inverse * b - middle, along = inverse * g;
    const Vec3 kept = middle + least + along * ((now - g.dot(least)) / g.dot(along));
    // Far from the edge the planes are nearly parallel and their meeting point means nothing.
    if (near(middle + least)) places[count++] = {cost(middle + least), middle + least};
    if (near(kept)) places[count++] = {cost(kept) / kVolumeWorth, kept};
  }
  std::stable_sort(places.begin(), places.begin() + count,
                   [](const PlaceForVertex& x, const PlaceForVertex& y) { return x.cost < y.cost; });
  const PlaceForVertex& place = places[std::min(rank, count - 1)];
  return {std::max(cost(place.at), 0.0) * std::max(m_importance[u], m_importance[v]), u, v, m_stamps[u], m_stamps[v], rank, place.at,
          g.dot(place.at - middle) - now};
}

void Collapser::push(int u, int v, int rank) {
  m_queue.push(candidate(std::min(u, v), std::max(u, v), rank));
}

bool Collapser::topologyAllows(int u, int v) const {
  const std::vector<int> a = neighbours(u), b = neighbours(v);
  std::vector<int> common;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::back_inserter(common));
  if (common.size() != 2) return false;
  // A common neighbour of three triangles would be left with two that lie on each other.
  return m_fans[common[0]].size() > 3 && m_fans[common[1]].size() > 3;
}

bool Collapser::cutsSurface(const std::vector<int>& star, int u, int v, const Vec3& at) const {
  Box3 around(at);
  std::vector<Triangle3> fan;  // with `at` in front
  for (const int t : star) {
    around.extend(boxOf(cornersAfter(t, u, v, at)));
    fan.push_back(cornersAfter(t, u, v, at));
    const auto& c = m_triangles[t];
    const int first = c[0] == u || c[0] == v ? 0 : c[1] == u || c[1] == v ? 1 : 2;
    std::rotate(fan.back().begin(), fan.back().begin() + first, fan.back().end());
  }
  for (std::size_t i = 0; i < fan.size(); ++i)
    for (std::size_t j = i + 1; j < fan.size(); ++j)
      if (fansCross(fan[i], fan[j], kCutTolerance)) return true;
  for (const int other : m_liveList) {
    if (m_dead[other] || contains(m_triangles[other], u) || contains(m_triangles[other], v)) continue;
    const Triangle3 q = corners(other);
    const Box3 box = boxOf(q);
    if (!around.intersects(box)) continue;
    for (const int t : star) {
      const Triangle3 p = cornersAfter(t, u, v, at);
      if (!boxOf(p).intersects(box)) continue;
      int common = 0, atP = 0, atQ = 0;
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j)
          if (m_triangles[t][i] == m_triangles[other][j]) ++common, atP = i, atQ = j;
      if (common > 1) continue;
      const Triangle3 a{p[atP], p[(atP + 1) % 3], p[(atP + 2) % 3]};
      const Triangle3 b{q[atQ], q[(atQ + 1) % 3], q[(atQ + 2) % 3]};
      if (common == 1 ? fansCross(a, b, kCutTolerance) : trianglesOverlap(a, b, kCutTolerance)) return true;
    }
  }
  return false;
}

bool Collapser::shapeAllows(const Candidate& c, const CollapseRules& rules) const {
  const double gained = std::abs(m_gained + c.gain);
  if (gained > rules.maxVolumeLoss * m_wanted && gained > std::abs(m_gained)) return false;
  std::vector<int> star;  // triangles that stay and change
  double shapeBefore = 1;
  for (const int w : {c.u, c.v})
    for (const int t : m_fans[w]) {
      shapeBefore = std::min(shapeBefore, shapeOf(corners(t)));
      if (!(contains(m_triangles[t], c.u) && contains(m_triangles[t], c.v))) star.push_back(t);
    }
  const double minShape = std::min(rules.minShape, shapeBefore);
  Vec3 patch = Vec3::Zero();
  for (const int w : {c.u, c.v})
    for (const int t : m_fans[w]) patch += areaVector(corners(t));
  for (const int t : star) {
    const Triangle3 before = corners(t), after = cornersAfter(t, c.u, c.v, c.at);
    if (shapeOf(after) < minShape) return false;
    // The normal of a sliver is chance: there the patch is the measure.
    const Vec3 was = shapeOf(before) < kSliver ? patch : areaVector(before);
    if (cosine(was, areaVector(after)) < rules.minTurn) return false;
  }
  // Neighbours of changed triangles: fold no more than the surface was folded there already.
  double foldBefore = 1;
  std::vector<std::pair<Triangle3, Triangle3>> pairs;
  for (const int t : star)
    for (int i = 0; i < 3; ++i) {
      const int a = m_triangles[t][i], b = m_triangles[t][(i + 1) % 3];
      for (const int other : m_fans[a]) {
        if (other == t || !contains(m_triangles[other], b)) continue;
        foldBefore = std::min(foldBefore, cosine(areaVector(corners(t)), areaVector(corners(other))));
      }
    }
  const double minFold = std::min(rules.minDihedral, foldBefore);
  const auto merged = [&](int w) { return w == c.v ? c.u : w; };
  for (const int t : star)
    for (int i = 0; i < 3; ++i) {
      const int a = m_triangles[t][i], b = m_triangles[t][(i + 1) % 3];
      const Vec3 normal = areaVector(cornersAfter(t, c.u, c.v, c.at));
      const int stays = a == c.u || a == c.v ? b : a;  // one end at least does not move
      for (const int other : m_fans[stays]) {
        const auto& o = m_triangles[other];
        if (other == t || (contains(o, c.u) && contains(o, c.v))) continue;
        int shared = 0;
        for (const int x : o) shared += merged(x) == merged(a) || merged(x) == merged(b);
        if (shared == 2 && cosine(normal, areaVector(cornersAfter(other, c.u, c.v, c.at))) < minFold)
          return false;
      }
    }
  return rules.allowCuts || m_alive > kCutTestBelow || !cutsSurface(star, c.u, c.v, c.at);
}

void Collapser::collapse(const Candidate& c) {
  const int u = c.u, v = c.v;
  for (const int t : std::vector<int>(m_fans[v])) {
    if (contains(m_triangles[t], u)) {
      m_dead[t] = 1;
      --m_alive;
      for (const int w : m_triangles[t]) std::erase(m_fans[w], t);
    } else {
      for (int& w : m_triangles[t])
        if (w == v) w = u;
      m_fans[u].push_back(t);
    }
  }
  m_fans[v].clear();
  std::sort(m_fans[u].begin(), m_fans[u].end());
  m_points[u] = c.at;
  m_planes[u] += m_planes[v];
  m_spread[u] += m_spread[v];
  m_importance[u] = std::max(m_importance[u], m_importance[v]);
  m_gained += c.gain;
  ++m_stamps[u], ++m_stamps[v];
  for (const int w : neighbours(u)) push(u, w);
  if (static_cast<int>(m_liveList.size()) > 2 * m_alive)
    std::erase_if(m_liveList, [this](int t) { return m_dead[t] != 0; });
}

void Collapser::run(int target, const CollapseRules& rules) {
  // A refused edge may become allowed when its surroundings change, so the queue is filled again until
  // a whole pass changes nothing.
  for (int before = -1; before != m_alive && m_alive > target + 1;) {
    before = m_alive;
    m_queue = Queue();
    for (const int t : m_liveList)
      if (!m_dead[t])
        for (int i = 0; i < 3; ++i)
          if (m_triangles[t][i] < m_triangles[t][(i + 1) % 3])
            push(m_triangles[t][i], m_triangles[t][(i + 1) % 3]);
    while (!m_queue.empty() && m_alive > target + 1) {
      const Candidate c = m_queue.top();
      m_queue.pop();
      if (c.stampU != m_stamps[c.u] || c.stampV != m_stamps[c.v]) continue;
      if (!topologyAllows(c.u, c.v)) continue;
      if (shapeAllows(c, rules))
        collapse(c);
      else if (c.rank + 1 < kPlaces)
        push(c.u, c.v, c.rank + 1);
    }
  }
}

TriMesh Collapser::result() const {
  TriMesh mesh;
  std::vector<int> number(m_points.size(), -1);
  for (std::size_t v = 0; v < m_points.size(); ++v)
    if (!m_fans[v].empty()) {
      number[v] = static_cast<int>(mesh.vertices.size());
      mesh.vertices.push_back(m_centre + m_scale * m_points[v]);
    }
  for (std::size_t t = 0; t < m_triangles.size(); ++t)
    if (!m_dead[t])
      mesh.triangles.push_back(
          {number[m_triangles[t][0]], number[m_triangles[t][1]], number[m_triangles[t][2]]});
  return mesh;
}

}  // namespace glenoid
