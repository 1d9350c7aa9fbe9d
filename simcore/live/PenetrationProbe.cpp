// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/live/PenetrationProbe.h"

#include <algorithm>
#include <cmath>

#include "simcore/body/SurfaceBinding.h"
#include "simcore/mesh/MeshHealth.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid {
namespace {

const SurfaceBinding& surfaceOf(const SceneObject& object, SurfaceKind kind) {
  return kind == SurfaceKind::Visual ? object.visual : object.collision;
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
  if (kind == SurfaceKind::Visual) m_underSkin = UnderSkin(model);
  for (const SceneObject& object : model.objects) m_positions.emplace_back(surfaceOf(object, kind).vertices.size());
  for (const auto& positions : m_positions) m_spans.emplace_back(positions);
}

void PenetrationProbe::setLimit(std::optional<double> depth) {
  m_limits.clear();
  for (const CollisionPair& pair : m_model.collisionPairs) {
    double limit = HUGE_VAL;
    for (const int object : {pair.surfaceA, pair.surfaceB}) limit = std::min(limit, meanThickness(*surfaceOf(m_model.objects[object], m_kind).mesh) / 3);
    m_limits.push_back(depth.value_or(limit));
  }
}

void PenetrationProbe::look(const VecX& q, std::span<const DentView> dents, double time, long step) {
  for (std::size_t i = 0; i < m_positions.size(); ++i) {
    const SceneObject& object = m_model.objects[i];
    surfacePositions(surfaceOf(object, m_kind), object.layout, q, m_positions[i]);
  }
  if (!m_underSkin.empty()) {
    m_underSkin.look(q, dents);
    for (std::size_t i = 0; i < m_positions.size(); ++i)
      if (const std::span<const Vec3> shifts = m_underSkin.shifts(static_cast<int>(i)); !shifts.empty())
        for (std::size_t v = 0; v < shifts.size(); ++v) m_positions[i][v] += shifts[v];
  }
  m_allowed.assign(m_model.collisionPairs.size(), 0.0);
  for (const DentView& dent : dents)
    for (std::size_t p = 0; p < m_allowed.size(); ++p) {
      const CollisionPair& pair = m_model.collisionPairs[p];
      if ((pair.surfaceA == dent.object && pair.surfaceB == dent.tool) || (pair.surfaceA == dent.tool && pair.surfaceB == dent.object))
        m_allowed[p] = std::max(m_allowed[p], dent.depth);
    }
  m_check.eachPair(m_spans, m_allowed, m_found);
  for (std::size_t p = 0; p < m_found.size(); ++p) {
    const double depth = m_found[p].depth;
    const CollisionPair& pair = m_model.collisionPairs[p];
    const std::string &a = m_model.objects[pair.surfaceA].id, &b = m_model.objects[pair.surfaceB].id;
    if (depth > m_deepest) {
      m_deepest = depth;
      m_where = a + " / " + (pair.self() ? "itself" : b);
    }
    if (m_limits.empty() || !(depth > m_limits[p])) continue;
    auto notice = std::find_if(m_beyond.begin(), m_beyond.end(), [&](const Notice& n) { return n.subject == a && n.other == b; });
    if (notice == m_beyond.end()) notice = m_beyond.insert(notice, {NoticeKind::TooDeep, a, b, 0, m_limits[p], 0, 0, {}});
    if (depth <= notice->figure) continue;
    notice->figure = depth;
    notice->time = time;
    notice->step = step;
  }
}

std::vector<Notice> PenetrationProbe::tooDeep() const {
  std::vector<Notice> notices = m_beyond;
  std::stable_sort(notices.begin(), notices.end(), [](const Notice& a, const Notice& b) { return a.figure * b.limit > b.figure * a.limit; });
  return notices;
}

}  // namespace glenoid
