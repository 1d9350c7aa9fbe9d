// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/render/ScopeView.h"

#include <algorithm>
#include <cmath>

#include "simcore/tool/ScopeOptics.h"
#include "simcore/train/Sight.h"

namespace glenoid {

double scopeRadius(int width, int height) { return 0.485 * std::min(width, height); }

std::optional<int> findScope(const Model& model, std::string_view id) {
  for (std::size_t i = 0; i < model.objects.size(); ++i) {
    const SceneObject& object = model.objects[i];
    if (object.tool && model.scenario.tools[object.toolIndex].kind == ToolKind::Arthroscope && (id.empty() || object.id == id)) return static_cast<int>(i);
  }
  return std::nullopt;
}

Layers throughScope(Layers layers, int object) {
  layers.objects.resize(std::max(layers.objects.size(), static_cast<std::size_t>(object) + 1));
  layers.objects[static_cast<std::size_t>(object)].visible = false;
  for (ObjectLook& look : layers.objects) look.selected = look.hovered = false;
  return layers;
}

ScopeSight scopeSight(const Model& model, const VecX& q, int object, int width, int height) {
  const Tool& tool = model.scenario.tools[model.objects[object].toolIndex];
  const ScopeView from = scopeView(model, q, object);
  ScopeSight sight;
  sight.look.halfField = halfFieldOf(tool);
  sight.look.hasNotch = tool.lens > 0;
  sight.look.notch = -tool.lensTurn;  // +Y is to the left of the picture, its up being +X
  sight.view.eye_W = from.lens_W;
  sight.view.target_W = from.lens_W + 0.02 * from.axis_W;
  sight.view.up_W = from.up_W;
  sight.view.fieldOfView = 2 * std::atan(std::tan(sight.look.halfField) * (height / 2.0) / scopeRadius(width, height));
  return sight;
}

std::optional<Vec2> seenThrough(const ScopeSight& sight, const Vec3& p_W, int width, int height) {
  const ViewAxes axes = axesOf(sight.view);
  const Vec3 way = p_W - sight.view.eye_W;
  const double depth = -way.dot(axes.back_W);
  if (!(depth > 0)) return std::nullopt;
  const Vec2 flat(way.dot(axes.right_W) / depth, way.dot(axes.up_W) / depth);  // tan θ by direction
  const double s = flat.norm() / std::tan(sight.look.halfField), l = sight.look.distortion;
  if (s > 1) return std::nullopt;
  // s (1 + λ r²) = r (1 + λ), the root that grows from 0.
  const double a = s * l, b = -(1 + l);
  const double r = s == 0 ? 0 : std::abs(a) < 1e-12 ? s / (1 + l) : (-b - std::sqrt(std::max(b * b - 4 * a * s, 0.0))) / (2 * a);
  const Vec2 at = flat.norm() > 0 ? Vec2(r * flat.normalized()) : Vec2::Zero();
  const double radius = scopeRadius(width, height);
  return Vec2(width / 2.0 + radius * at.x(), height / 2.0 - radius * at.y());
}

}  // namespace glenoid
