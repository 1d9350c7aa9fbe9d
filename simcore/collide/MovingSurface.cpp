// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/collide/MovingSurface.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <limits>

#include "simcore/base/PlainMath.h"
#include "simcore/base/PlainMath.h"
#include "simcore/spatial/TrianglePoint.h"

namespace glenoid {
namespace {

BoxTree restTree(const CollisionSurface& surface) {
  std::vector<Box3> boxes(surface.triangles.size());
  for (std::size_t t = 0; t < boxes.size(); ++t) {
    for (const int v : surface.triangles[t]) boxes[t].extend(surface.restVertices[v]);
  }
  return BoxTree(boxes);
}

/// Angle between two vectors, by a form that keeps its digits near 0 and π.
double angleBetween(const Vec3& a, const Vec3& b) {
  return plain::arcTangent(a.cross(b).norm(), a.dot(b));
}

}  // namespace

MovingSurface::MovingSurface(std::shared_ptr<const CollisionSurface> topology)
    : m_topology(std::move(topology)), m_tree(restTree(*m_topology)) {
  const std::size_t triangles = m_topology->triangles.size();
  m_speed.resize(m_topology->vertexCount);
  m_faceNormal.resize(triangles);
  m_faceOffset.resize(triangles);
  m_margin.resize(triangles);
  m_hasFace.resize(triangles);
  m_lanes.resize(triangles);
  m_bend.resize(m_topology->edges.size());
  m_bends.resize(triangles);
  m_vertexNormal.resize(m_topology->vertexCount);
  m_vertexNormalStep.assign(m_topology->vertexCount, -1);
}

void MovingSurface::update(std::span<const Vec3> positions, std::span<const std::span<const Vec3>> motions,
                           double contactDistance, double dt) {
  const CollisionSurface& s = *m_topology;
  assert(static_cast<int>(positions.size()) == s.vertexCount);
  assert(motions.size() <= m_v.size());
  ++m_step;
  m_x = positions;
  m_v.fill({});
  std::copy(motions.begin(), motions.end(), m_v.begin());
  double sum = 0, largest = 0;  // the sum is not finite as soon as one entry is not
  for (const Vec3& p : positions) {
    sum += p.sum();
    largest = std::max(largest, p.cwiseAbs().maxCoeff());
  }
  // Corner, normal and offset are rounded once, then three products and three sums: under 25 units of 2⁻²⁴.
  m_laneSlack = static_cast<float>(32 * largest) * std::numeric_limits<float>::epsilon();
  bool moves = false;
  for (std::size_t motion = 0; motion < motions.size(); ++motion) {
    const std::span<const Vec3> velocities = motions[motion];
    assert(velocities.empty() || velocities.size() == positions.size());
    Vec3& drift = m_drift[motion] = Vec3::Zero();
    for (const Vec3& v : velocities) drift += v;
    if (!velocities.empty()) drift /= static_cast<double>(velocities.size());
    for (std::size_t i = 0; i < velocities.size(); ++i) {
      const double speed = (velocities[i] - drift).norm();
      sum += speed;
      m_speed[i] = moves ? std::max(m_speed[i], speed) : speed;
    }
    moves = moves || !velocities.empty();
  }
  m_usable = std::isfinite(sum) && !s.triangles.empty();
  if (!m_usable) return;

  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    const auto [i, j, k] = s.triangles[t];
    const Vec3 &a = m_x[i], &b = m_x[j], &c = m_x[k];
    const Vec3 twice = (b - a).cross(c - a);
    m_hasFace[t] = !s.empty[t] && !isFlatTriangle(a, b, c);
    m_faceNormal[t] = m_hasFace[t] ? Vec3(twice / twice.norm()) : Vec3(Vec3::Zero());
    m_faceOffset[t] = m_faceNormal[t].dot(a);
    Lanes& lanes = m_lanes[t];
    const Vec3* corners[4] = {&a, &b, &c, &a};
    for (int lane = 0; lane < 4; ++lane) {
      lanes.x[lane] = static_cast<float>(corners[lane]->x());
      lanes.y[lane] = static_cast<float>(corners[lane]->y());
      lanes.z[lane] = static_cast<float>(corners[lane]->z());
    }
    for (int axis = 0; axis < 3; ++axis) lanes.normal[axis] = static_cast<float>(m_faceNormal[t][axis]);
    lanes.offset = static_cast<float>(m_faceOffset[t]);
    const double speed = !moves ? 0 : std::max({m_speed[i], m_speed[j], m_speed[k]});
    m_margin[t] = 0.5 * contactDistance + std::min(speed * dt, ahead());
    const Vec3 reach = Vec3::Constant(m_margin[t]);
    m_tree.setBox(static_cast<int>(t), a.cwiseMin(b).cwiseMin(c) - reach, a.cwiseMax(b).cwiseMax(c) + reach);
  }
  m_tree.refit();
  for (std::size_t e = 0; e < s.edges.size(); ++e) {
    const CollisionSurface::Edge& edge = s.edges[e];
    if (edge.triangles[1] < 0) {
      m_bend[e] = Bend::None;
      continue;
    }
    const Vec3 away = m_x[edge.opposite[1]] - m_x[edge.vertices[0]];
    const double above = m_faceNormal[edge.triangles[0]].dot(away);
    const bool convex = above < 0 && above * above > 1e-6 * away.squaredNorm();
    m_bend[e] = convex ? Bend::Convex : s.deforms ? Bend::Dentable : Bend::None;
  }
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    Bends& bends = m_bends[t] = {};
    for (int k = 0; k < 3; ++k) {
      const Bend bend = m_bend[s.triangleEdges[t][k]];
      bends.convex |= static_cast<std::uint8_t>((bend == Bend::Convex) << k);
      bends.dentable |= static_cast<std::uint8_t>((bend == Bend::Dentable) << k);
    }
  }
}

Vec3 MovingSurface::edgeNormal(int edge) const {
  const auto& t = m_topology->edges[edge].triangles;
  return t[1] < 0 ? m_faceNormal[t[0]] : Vec3(m_faceNormal[t[0]] + m_faceNormal[t[1]]);
}

const Vec3& MovingSurface::vertexNormal(int vertex) {
  if (m_vertexNormalStep[vertex] == m_step) return m_vertexNormal[vertex];
  m_vertexNormalStep[vertex] = m_step;
  Vec3 normal = Vec3::Zero();
  for (const int t : m_topology->trianglesOf(vertex)) {
    const auto& corner = m_topology->triangles[t];
    const int k = corner[0] == vertex ? 0 : (corner[1] == vertex ? 1 : 2);
    const Vec3& p = m_x[vertex];
    normal += angleBetween(m_x[corner[(k + 1) % 3]] - p, m_x[corner[(k + 2) % 3]] - p) * m_faceNormal[t];
  }
  return m_vertexNormal[vertex] = normal;
}

MovingSurface::Feature MovingSurface::featureOf(int triangle, const Vec3& w) const {
  const bool on0 = w[0] > 0, on1 = w[1] > 0, on2 = w[2] > 0;
  const auto& corner = m_topology->triangles[triangle];
  const auto& side = m_topology->triangleEdges[triangle];
  if (on0 && on1 && on2) return {FeatureKind::Face, triangle};
  if (on0 && on1) return {FeatureKind::Edge, side[0]};
  if (on1 && on2) return {FeatureKind::Edge, side[1]};
  if (on0 && on2) return {FeatureKind::Edge, side[2]};
  return {FeatureKind::Vertex, on0 ? corner[0] : (on1 ? corner[1] : corner[2])};
}

Vec3 MovingSurface::normalOf(const Feature& feature) {
  switch (feature.kind) {
    case FeatureKind::Face:
      return m_faceNormal[feature.id];
    case FeatureKind::Edge:
      return edgeNormal(feature.id);
    case FeatureKind::Vertex:
      break;
  }
  return vertexNormal(feature.id);
}

MovingSurface::Nearest MovingSurface::nearest(const Vec3& p, double reach) {
  return nearestOf(p, reach, [](int, double) { return true; });
}

MovingSurface::Nearest MovingSurface::leaving(const Vec3& p, const Vec3& way, double slack) const {
  constexpr double kGrazing = 1e-6;  // cosine
  Nearest found;
  found.distance = 2 * m_topology->size;
  const Vec3 inverse = way.cwiseInverse();
  const auto meets = [&](const BoxTree::Node& node) {
    double from = 0, to = found.distance;
    for (int k = 0; k < 3; ++k) {
      if (way[k] == 0) {
        if (p[k] < node.low[k] || p[k] > node.high[k]) return false;
        continue;
      }
      const double one = (node.low[k] - p[k]) * inverse[k], other = (node.high[k] - p[k]) * inverse[k];
      from = std::max(from, std::min(one, other));
      to = std::min(to, std::max(one, other));
    }
    return from <= to;
  };
  m_tree.walk(meets, [&](int t) {
    const double along = m_faceNormal[t].dot(way);
    if (!m_hasFace[t] || along < kGrazing) return;
    const double s = -height(t, p) / along;
    if (!(s >= 0 && s < found.distance)) return;
    const auto [i, j, k] = m_topology->triangles[t];
    const Vec3 there = p + s * way, w = nearestBarycentric(there, m_x[i], m_x[j], m_x[k]);
    const Vec3 foot = w[0] * m_x[i] + w[1] * m_x[j] + w[2] * m_x[k];
    if ((foot - there).squaredNorm() > slack * slack) return;
    found.triangle = t;
    found.barycentric = w;
    found.point = foot;
    found.distance = s;
  });
  found.feature = {FeatureKind::Face, found.triangle};
  found.inside = true;
  return found;
}

}  // namespace glenoid
