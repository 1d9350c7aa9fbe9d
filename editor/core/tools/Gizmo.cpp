// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/tools/Gizmo.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>

namespace glenoid {
namespace {

constexpr double kArrowPx = 78, kReachPx = 7, kMiddlePx = 9;
constexpr double kNear = 0.32, kFar = 0.56;  ///< of a plane's square along its two axes, share of the arrow

/// The two axes that span a plane's grip.
std::array<int, 2> axesOfPlane(Gizmo::Grip grip) {
  switch (grip) {
    case Gizmo::Grip::YZ:
      return {1, 2};
    case Gizmo::Grip::ZX:
      return {2, 0};
    default:
      return {0, 1};
  }
}

double distanceToSegment(const Vec2& p, const Vec2& a, const Vec2& b) {
  const Vec2 along = b - a;
  const double length2 = along.squaredNorm();
  const double s = length2 > 0 ? std::clamp((p - a).dot(along) / length2, 0.0, 1.0) : 0.0;
  return (p - a - s * along).norm();
}

std::optional<Vec3> onPlane(const Viewport& viewport, const Vec2& pixel, const Vec3& point,
                            const Vec3& normal) {
  const Ray ray = rayThrough(viewport.view, pixel.x(), pixel.y(), viewport.width, viewport.height);
  const double slope = ray.direction_W.dot(normal);
  if (std::abs(slope) < 0.05) return std::nullopt;  // nearly edge on: a pixel would be metres
  const double t = (point - ray.origin_W).dot(normal) / slope;
  if (t <= 0) return std::nullopt;
  return ray.origin_W + t * ray.direction_W;
}

}  // namespace

Gizmo::Gizmo(const Viewport& viewport, const Vec3& centre_W) : m_viewport(viewport), m_centre(centre_W) {
  const double depth = std::max((viewport.view.eye_W - centre_W).dot(axesOf(viewport.view).back_W), 1e-3);
  m_length = kArrowPx * 2 * depth * std::tan(viewport.view.fieldOfView / 2) / std::max(viewport.height, 1);
}

Gizmo::Grip Gizmo::at(const Vec2& pixel) const {
  const auto seen = [this](const Vec3& p) {
    return projected(m_viewport.view, p, m_viewport.width, m_viewport.height);
  };
  const auto middle = seen(m_centre);
  if (!middle) return Grip::None;
  if ((pixel - *middle).norm() <= kMiddlePx) return Grip::Screen;
  for (const Grip grip : {Grip::YZ, Grip::ZX, Grip::XY}) {
    const auto axes = axesOfPlane(grip);
    const Vec3 u = m_length * Vec3::Unit(axes[0]), v = m_length * Vec3::Unit(axes[1]);
    std::array<std::optional<Vec2>, 4> corners = {
        seen(m_centre + kNear * u + kNear * v), seen(m_centre + kFar * u + kNear * v),
        seen(m_centre + kFar * u + kFar * v), seen(m_centre + kNear * u + kFar * v)};
    int left = 0, right = 0;
    for (int i = 0; i < 4; ++i) {
      if (!corners[i] || !corners[(i + 1) % 4]) continue;
      const Vec2 edge = *corners[(i + 1) % 4] - *corners[i], to = pixel - *corners[i];
      (edge.x() * to.y() - edge.y() * to.x() > 0 ? left : right)++;
    }
    if (left == 4 || right == 4) return grip;
  }
  Grip nearest = Grip::None;
  double best = kReachPx;
  for (int axis = 0; axis < 3; ++axis) {
    const auto tip = seen(m_centre + m_length * Vec3::Unit(axis));
    if (!tip || (*tip - *middle).norm() < kMiddlePx) continue;  // seen from its end
    const double distance = distanceToSegment(pixel, *middle, *tip);
    if (distance >= best) continue;
    best = distance;
    nearest = static_cast<Grip>(static_cast<int>(Grip::X) + axis);
  }
  return nearest;
}

Vec3 Gizmo::shift(Grip grip, const Vec2& from, const Vec2& to) const {
  switch (grip) {
    case Grip::None:
      return Vec3::Zero();
    case Grip::X:
    case Grip::Y:
    case Grip::Z: {
      // In the plane that holds the axis and faces the viewer best, then along the axis.
      const Vec3 axis = Vec3::Unit(static_cast<int>(grip) - static_cast<int>(Grip::X));
      const Vec3 gaze = m_centre - m_viewport.view.eye_W;
      const Vec3 normal = (gaze - gaze.dot(axis) * axis).normalized();
      const auto a = onPlane(m_viewport, from, m_centre, normal),
                 b = onPlane(m_viewport, to, m_centre, normal);
      return a && b ? Vec3((*b - *a).dot(axis) * axis) : Vec3(Vec3::Zero());
    }
    default:
      break;
  }
  Vec3 normal = axesOf(m_viewport.view).back_W;
  if (grip != Grip::Screen) {
    const auto axes = axesOfPlane(grip);
    normal = Vec3::Unit(3 - axes[0] - axes[1]);
  }
  const auto a = onPlane(m_viewport, from, m_centre, normal), b = onPlane(m_viewport, to, m_centre, normal);
  return a && b ? Vec3(*b - *a) : Vec3(Vec3::Zero());
}

Strokes Gizmo::strokes(Grip hot) const {
  // Anterior red, superior green, lateral and medial blue, as the marker in the corner has them.
  static constexpr std::array<std::array<float, 3>, 3> kColors{
      {{0.90f, 0.25f, 0.22f}, {0.35f, 0.75f, 0.30f}, {0.30f, 0.50f, 0.95f}}};
  Strokes out;
  out.linePx = 3;
  out.dotPx = 11;
  out.hiddenStrength = 0.85f;  // it must be found inside the tissue as well
  const auto colorOf = [&](Grip grip, const std::array<float, 3>& base) {
    std::array<float, 4> color{base[0], base[1], base[2], 0.95f};
    if (grip == hot) color = {1.0f, 0.90f, 0.35f, 1};
    return color;
  };
  const auto line = [&out](const Vec3& a, const Vec3& b, const std::array<float, 4>& color) {
    out.lines.push_back({a.cast<float>(), color});
    out.lines.push_back({b.cast<float>(), color});
  };
  for (int axis = 0; axis < 3; ++axis) {
    const auto color = colorOf(static_cast<Grip>(static_cast<int>(Grip::X) + axis), kColors[axis]);
    const Vec3 along = m_length * Vec3::Unit(axis), u = m_length * Vec3::Unit((axis + 1) % 3),
               v = m_length * Vec3::Unit((axis + 2) % 3);
    line(m_centre, m_centre + along, color);
    for (const Vec3& side : {u, Vec3(-u), v, Vec3(-v)})
      line(m_centre + along, m_centre + 0.84 * along + 0.06 * side, color);
    const auto plane = colorOf(static_cast<Grip>(static_cast<int>(Grip::YZ) + axis), kColors[axis]);
    const Vec3 corners[] = {kNear * u + kNear * v, kFar * u + kNear * v, kFar * u + kFar * v,
                            kNear * u + kFar * v};
    for (int i = 0; i < 4; ++i) line(m_centre + corners[i], m_centre + corners[(i + 1) % 4], plane);
  }
  out.dots.push_back({m_centre.cast<float>(), colorOf(Grip::Screen, {0.92f, 0.92f, 0.92f})});
  return out;
}

}  // namespace glenoid
