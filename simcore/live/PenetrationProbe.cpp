// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/live/PenetrationProbe.h"

#include "simcore/body/SurfaceBinding.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid {
namespace {

const SurfaceBinding& surfaceOf(const SceneObject& object, SurfaceKind kind) {
  return kind == SurfaceKind::Visual ? object.visual : object.collision;
}

/// Twice the volume over the area, m; infinite where a surface encloses nothing.
double thicknessOf(const TriMesh& mesh) {
  double area = 0;
  for (const auto& t : mesh.triangles)
    area += 0.5 * (mesh.vertices[t[1]] - mesh.vertices[t[0]]).cross(mesh.vertices[t[2]] - mesh.vertices[t[0]]).norm();
  const double volume = enclosedVolume(mesh);
  return volume > 0 && area > 0 ? 2 * volume / area : HUGE_VAL;
}

/// Which visual triangles to skip: those whose centroid lies nearest to a skipped collision triangle.
std::vector<char> visualSkip(const TriMesh& visual, const TriMesh& collision, const std::vector<char>& skip) {
  if (skip.empty() || collision.triangles.empty()) return {};
  const TriangleTree tree(collision);
  std::vector<char> result;
  for (const auto& t : visual.triangles) {
    const Vec3 centroid = (visual.vertices[t[0]] + visual.vertices[t[1]] + visual.vertices[t[2]]) / 3;
    const int nearest = tree.closest(centroid).triangle;
    result.push_back(nearest >= 0 ? skip[nearest] : 0);
  }
  return result;
}

PenetrationCheck makeCheck(const Model& model, SurfaceKind kind) {
  if (kind == SurfaceKind::Collision) return PenetrationCheck(model.collisionSurfaces, model.collisionPairs);
  std::vector<std::shared_ptr<const CollisionSurface>> surfaces;
  for (const SceneObject& object : model.objects) surfaces.push_back(makeCollisionSurface(*object.visual.mesh));
  std::vector<CollisionPair> pairs = model.collisionPairs;
  for (CollisionPair& pair : pairs) {
    const SceneObject &a = model.objects[pair.surfaceA], &b = model.objects[pair.surfaceB];
    pair.skipTriangleA = visualSkip(*a.visual.mesh, *a.collision.mesh, pair.skipTriangleA);
    pair.skipTriangleB = visualSkip(*b.visual.mesh, *b.collision.mesh, pair.skipTriangleB);
  }
  return PenetrationCheck(std::move(surfaces), std::move(pairs));
}

}  // namespace

PenetrationProbe::PenetrationProbe(const Model& model, SurfaceKind kind)
    : m_model(model), m_kind(kind), m_check(makeCheck(model, kind)) {
  for (const SceneObject& object : model.objects) m_positions.emplace_back(surfaceOf(object, kind).vertices.size());
  for (const auto& positions : m_positions) m_spans.emplace_back(positions);
}

void PenetrationProbe::setLimit(std::optional<double> depth) {
  m_limits.clear();
  for (const CollisionPair& pair : m_model.collisionPairs) {
    double limit = HUGE_VAL;
    for (const int object : {pair.surfaceA, pair.surfaceB}) limit = std::min(limit, thicknessOf(*surfaceOf(m_model.objects[object], m_kind).mesh) / 3);
    m_limits.push_back(depth.value_or(limit));
  }
  m_leastLimit = m_limits.empty() ? HUGE_VAL : *std::min_element(m_limits.begin(), m_limits.end());
}

void PenetrationProbe::look(const VecX& q, std::span<const DentView> dents, double time, long step) {
  for (std::size_t i = 0; i < m_positions.size(); ++i) {
    const SceneObject& object = m_model.objects[i];
    surfacePositions(surfaceOf(object, m_kind), object.layout, q, m_positions[i]);
  }
  m_allowed.assign(m_model.collisionPairs.size(), 0.0);
  for (const DentView& dent : dents)
    for (std::size_t p = 0; p < m_allowed.size(); ++p) {
      const CollisionPair& pair = m_model.collisionPairs[p];
      if ((pair.surfaceA == dent.object && pair.surfaceB == dent.tool) || (pair.surfaceA == dent.tool && pair.surfaceB == dent.object))
        m_allowed[p] = std::max(m_allowed[p], dent.depth);
    }
  const Penetration found = m_check.deepest(m_spans, m_allowed);
  if (found.pair >= 0 && !m_limits.empty() && found.depth > m_leastLimit) lookBeyondLimits(time, step);
  if (found.pair < 0 || found.depth <= m_deepest) return;
  m_deepest = found.depth;
  const CollisionPair& pair = m_model.collisionPairs[found.pair];
  m_where = m_model.objects[pair.surfaceA].id + " / " + m_model.objects[pair.surfaceB].id;
}

void PenetrationProbe::lookBeyondLimits(double time, long step) {
  for (std::size_t p = 0; p < m_limits.size(); ++p) m_allowed[p] += m_limits[p];
  const Penetration beyond = m_check.deepest(m_spans, m_allowed);
  if (beyond.pair < 0 || !(beyond.depth > 0)) return;
  const double limit = m_limits[beyond.pair], depth = beyond.depth + limit;
  if (m_tooDeep && depth * m_tooDeep->limit <= m_tooDeep->figure * limit) return;
  const CollisionPair& pair = m_model.collisionPairs[beyond.pair];
  m_tooDeep = Notice{NoticeKind::TooDeep, m_model.objects[pair.surfaceA].id, m_model.objects[pair.surfaceB].id, depth, limit, time, step, {}};
}

}  // namespace glenoid
