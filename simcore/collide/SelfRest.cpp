// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/collide/SelfRest.h"

#include "simcore/spatial/Intersect.h"
#include "simcore/spatial/TrianglePoint.h"

namespace glenoid {
namespace {

/// Shares along two segments p + s u and q + t v at which they are nearest. Source: Ericson, "Real-Time Collision
/// Detection", 2005, §5.1.9.
std::array<double, 2> nearestOnSegments(const Vec3& p, const Vec3& u, const Vec3& q, const Vec3& v) {
  const Vec3 r = p - q;
  const double a = u.squaredNorm(), e = v.squaredNorm(), f = v.dot(r), c = u.dot(r), b = u.dot(v), det = a * e - b * b;
  if (!(a > 0) || !(e > 0)) return {0, 0};
  double s = det > 1e-12 * a * e ? std::clamp((b * f - c * e) / det, 0.0, 1.0) : 0.0;
  double t = (b * s + f) / e;
  if (t < 0) {
    t = 0;
    s = std::clamp(-c / a, 0.0, 1.0);
  } else if (t > 1) {
    t = 1;
    s = std::clamp((b - c) / a, 0.0, 1.0);
  }
  return {s, t};
}

}  // namespace

SelfRest::SelfRest(std::shared_ptr<const CollisionSurface> surface, std::vector<int> cellOfVertex)
    : m_surface(std::move(surface)), m_cellOfVertex(std::move(cellOfVertex)) {
  const CollisionSurface& s = *m_surface;
  m_vertexNormal.assign(s.vertexCount, Vec3::Zero());
  for (std::size_t t = 0; t < s.triangles.size(); ++t) {
    const auto [i, j, k] = s.triangles[t];
    const Vec3 twice = (s.restVertices[j] - s.restVertices[i]).cross(s.restVertices[k] - s.restVertices[i]);
    m_faceNormal.push_back(s.empty[t] ? Vec3(Vec3::Zero()) : Vec3(twice.stableNormalized()));
    m_centre.push_back((s.restVertices[i] + s.restVertices[j] + s.restVertices[k]) / 3);
    double radius = 0;
    for (const int v : s.triangles[t]) radius = std::max(radius, (s.restVertices[v] - m_centre.back()).norm());
    m_radius.push_back(radius);
    if (s.empty[t]) continue;
    for (const int v : s.triangles[t]) m_vertexNormal[v] += twice;  // by area: which way is out is all that is asked
  }
  for (Vec3& normal : m_vertexNormal)
    if (!normal.isZero(0)) normal.stableNormalize();
  m_crossing = selfIntersections(TriMesh{s.restVertices, s.triangles});
}

SelfRest::Apart SelfRest::apart(const Vec3& a, const Vec3& normalA, const Vec3& b, const Vec3& normalB) const {
  const Vec3 way = a - b;
  const double distance = way.norm();
  // Where they touch at rest there is no way between them; what looks at each other then faces each other.
  if (distance <= kRounding * m_surface->size) return {distance, normalA.dot(normalB) < -kFacing};
  return {distance, way.dot(normalB) > kFacing * distance && -way.dot(normalA) > kFacing * distance};
}

SelfRest::Apart SelfRest::vertexAndTriangle(int vertex, int triangle) const {
  const CollisionSurface& s = *m_surface;
  const auto [i, j, k] = s.triangles[triangle];
  const Vec3 &p = s.restVertices[vertex], &a = s.restVertices[i], &b = s.restVertices[j], &c = s.restVertices[k];
  const Vec3 w = nearestBarycentric(p, a, b, c);
  return apart(p, m_vertexNormal[vertex], w[0] * a + w[1] * b + w[2] * c, m_faceNormal[triangle]);
}

SelfRest::Apart SelfRest::edgePointAndTriangle(int edge, double t, int triangle) const {
  const CollisionSurface& s = *m_surface;
  const auto& ends = s.edges[edge].vertices;
  const auto [i, j, k] = s.triangles[triangle];
  const Vec3 p = (1 - t) * s.restVertices[ends[0]] + t * s.restVertices[ends[1]];
  const Vec3 &a = s.restVertices[i], &b = s.restVertices[j], &c = s.restVertices[k];
  const Vec3 w = nearestBarycentric(p, a, b, c);
  return apart(p, edgeNormal(edge), w[0] * a + w[1] * b + w[2] * c, m_faceNormal[triangle]);
}

Vec3 SelfRest::edgeNormal(int edge) const {
  const auto& t = m_surface->edges[edge].triangles;
  const Vec3 sum = t[1] < 0 ? m_faceNormal[t[0]] : Vec3(m_faceNormal[t[0]] + m_faceNormal[t[1]]);
  return sum.isZero(0) ? sum : Vec3(sum.stableNormalized());
}

SelfRest::Apart SelfRest::edges(int ea, int eb) const {
  const CollisionSurface& s = *m_surface;
  const auto &endsA = s.edges[ea].vertices, &endsB = s.edges[eb].vertices;
  const Vec3 &p = s.restVertices[endsA[0]], &q = s.restVertices[endsB[0]];
  const Vec3 u = s.restVertices[endsA[1]] - p, v = s.restVertices[endsB[1]] - q;
  const auto [a, b] = nearestOnSegments(p, u, q, v);
  return apart(p + a * u, edgeNormal(ea), q + b * v, edgeNormal(eb));
}

bool SelfRest::edgesShare(int ea, int eb) const {
  const auto &a = m_surface->edges[ea].vertices, &b = m_surface->edges[eb].vertices;
  return a[0] == b[0] || a[0] == b[1] || a[1] == b[0] || a[1] == b[1];
}

bool SelfRest::sameCell(const FeaturePoint& a, const FeaturePoint& b) const {
  if (m_cellOfVertex.empty()) return false;
  const int cell = m_cellOfVertex[a.vertex[0]];
  bool same = cell >= 0;
  for (int k = 0; k < a.count; ++k) same = same && m_cellOfVertex[a.vertex[k]] == cell;
  for (int k = 0; k < b.count; ++k) same = same && m_cellOfVertex[b.vertex[k]] == cell;
  return same;
}

}  // namespace glenoid
