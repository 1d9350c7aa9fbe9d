// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/train/Sight.h"

#include <cmath>

#include "simcore/body/State.h"
#include "simcore/tool/ScopeOptics.h"
#include "simcore/train/BoundPlace.h"

namespace glenoid {
namespace {

/// Share of the way from `from` along `way` at which it meets the triangle, in (0, 1); infinity where it does not.
/// Source: Möller and Trumbore, "Fast, Minimum Storage Ray/Triangle Intersection", J. Graphics Tools 2(1), 1997.
double meets(const Vec3& from, const Vec3& way, const Vec3& a, const Vec3& b, const Vec3& c) {
  const Vec3 e1 = b - a, e2 = c - a, p = way.cross(e2);
  const double determinant = e1.dot(p);
  if (determinant == 0) return INFINITY;
  const Vec3 s = from - a, r = s.cross(e1);
  const double u = s.dot(p) / determinant, v = way.dot(r) / determinant, t = e2.dot(r) / determinant;
  return u >= 0 && v >= 0 && u + v <= 1 && t > 0 && t < 1 ? t : INFINITY;
}

}  // namespace

ScopeView scopeView(const Model& model, const VecX& q, int tool) {
  const SceneObject& object = model.objects[tool];
  const Quat turn = poseAt(q, object.layout.qOffset).q_WB;
  const ScopeAxes axes = scopeAxes(model.scenario.tools[object.toolIndex]);
  return {CarriedPoint(model, tool, Vec3::Zero()).at(model, q), turn * axes.forward_B, turn * axes.up_B};
}

bool inSight(const Model& model, const VecX& q, int tool, const Vec3& from_W, const Vec3& to_W, double tolerance) {
  const Vec3 way = to_W - from_W;
  const double length = way.norm(), last = length > 0 ? 1 - tolerance / length : 0;
  if (!(last > 0)) return true;
  std::vector<Vec3> corners;
  for (std::size_t i = 0; i < model.objects.size(); ++i) {
    const SceneObject& object = model.objects[i];
    if (static_cast<int>(i) == tool || !object.collision.mesh) continue;
    corners.resize(object.collision.vertices.size());
    surfacePositions(object.collision, object.layout, q, corners);
    for (const auto& [a, b, c] : object.collision.mesh->triangles)
      if (meets(from_W, way, corners[a], corners[b], corners[c]) < last) return false;
  }
  return true;
}

}  // namespace glenoid
