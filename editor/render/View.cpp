// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/render/View.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glenoid {
namespace {

constexpr double kNearest = 2e-3, kFarthest = 20;  ///< m between eye and target

double distanceOf(const View& view) {
  return std::max((view.eye_W - view.target_W).norm(), 1e-9);
}

/// Height of the window in the target's plane, m.
double targetHeight(const View& view) {
  return 2 * distanceOf(view) * std::tan(view.fieldOfView / 2);
}

}  // namespace

ViewAxes axesOf(const View& view) {
  ViewAxes axes;
  const Vec3 back = view.eye_W - view.target_W;
  axes.back_W = back.norm() > 1e-12 ? Vec3(back.normalized()) : Vec3(Vec3::UnitZ());
  Vec3 right = view.up_W.cross(axes.back_W);
  if (right.norm() < 1e-9) right = axes.back_W.unitOrthogonal();  // up along the gaze: any right will do
  axes.right_W = right.normalized();
  axes.up_W = axes.back_W.cross(axes.right_W);
  return axes;
}

View orbited(const View& view, double yaw, double pitch) {
  const ViewAxes axes = axesOf(view);
  // How far the camera's up may still lean before the camera is upside down: up·Y = cos of the elevation.
  const double elevation = std::atan2(axes.back_W.y(), axes.up_W.y());
  const double limit = std::numbers::pi / 2;
  const double allowed =
      std::clamp(elevation + pitch, std::min(elevation, -limit), std::max(elevation, limit)) - elevation;
  const Quat turn =
      Quat(Eigen::AngleAxisd(-yaw, Vec3::UnitY())) * Quat(Eigen::AngleAxisd(-allowed, axes.right_W));
  View out = view;
  out.eye_W = view.target_W + turn * (view.eye_W - view.target_W);
  out.up_W = turn * axes.up_W;
  return out;
}

View panned(const View& view, double dx, double dy, int heightPx) {
  const ViewAxes axes = axesOf(view);
  const double scale = targetHeight(view) / std::max(heightPx, 1);
  const Vec3 shift = scale * (-dx * axes.right_W + dy * axes.up_W);
  View out = view;
  out.eye_W += shift;
  out.target_W += shift;
  return out;
}

View zoomedAt(const View& view, double factor, double x, double y, int widthPx, int heightPx) {
  const double before = distanceOf(view);
  const double after = std::clamp(before * factor, std::min(before, kNearest), std::max(before, kFarthest));
  const double ratio = after / before;
  const ViewAxes axes = axesOf(view);
  const double scale = targetHeight(view) / std::max(heightPx, 1);
  // The point under the cursor in the target's plane stays under the cursor: the target moves towards it.
  const Vec3 offset = scale * ((x - widthPx / 2.0) * axes.right_W - (y - heightPx / 2.0) * axes.up_W);
  View out = view;
  out.target_W = view.target_W + (1 - ratio) * offset;
  out.eye_W = out.target_W + after * axes.back_W;
  return out;
}

View framed(const View& view, const Box3& box_W, double aspect) {
  if (box_W.isEmpty()) return view;
  const ViewAxes axes = axesOf(view);
  const double tanY = std::tan(view.fieldOfView / 2) / 1.08, tanX = tanY * std::max(aspect, 1e-3);
  // Nearest distance at which every corner stays inside the four side planes.
  double distance = kNearest;
  for (int corner = 0; corner < 8; ++corner) {
    const Vec3 d = box_W.corner(static_cast<Box3::CornerType>(corner)) - box_W.center();
    const double depth = d.dot(axes.back_W);
    distance = std::max(
        {distance, depth + std::abs(d.dot(axes.right_W)) / tanX, depth + std::abs(d.dot(axes.up_W)) / tanY});
  }
  View out = view;
  out.target_W = box_W.center();
  out.eye_W = out.target_W + std::min(distance, kFarthest) * axes.back_W;
  return out;
}

const char* sideName(Side side) {
  switch (side) {
    case Side::Anterior:
      return "anterior";
    case Side::Posterior:
      return "posterior";
    case Side::Lateral:
      return "lateral";
    case Side::Medial:
      return "medial";
    case Side::Superior:
      return "superior";
    case Side::Inferior:
      return "inferior";
  }
  return "";
}

std::optional<Side> sideNamed(std::string_view name) {
  for (const Side side : kSides)
    if (name == sideName(side)) return side;
  return std::nullopt;
}

View viewFrom(Side side, const Box3& box_W, double aspect, double fieldOfView, JointSide of) {
  Vec3 back = Vec3::UnitX(), up = Vec3::UnitY();
  switch (side) {
    case Side::Anterior:
      break;
    case Side::Posterior:
      back = -Vec3::UnitX();
      break;
    case Side::Lateral:
      back = lateralSign(of) * Vec3::UnitZ();
      break;
    case Side::Medial:
      back = -lateralSign(of) * Vec3::UnitZ();
      break;
    case Side::Superior:
      back = Vec3::UnitY(), up = Vec3::UnitX();
      break;
    case Side::Inferior:
      back = -Vec3::UnitY(), up = Vec3::UnitX();
      break;
  }
  View view;
  view.fieldOfView = fieldOfView;
  view.target_W = box_W.isEmpty() ? Vec3(Vec3::Zero()) : Vec3(box_W.center());
  view.eye_W = view.target_W + 0.5 * back;
  view.up_W = up;
  return framed(view, box_W, aspect);
}

View viewOf(const Camera& camera) {
  return {camera.eye_W, camera.target_W, camera.up_W, camera.fieldOfView};
}

Eigen::Matrix4d viewMatrix(const View& view) {
  const ViewAxes axes = axesOf(view);
  Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
  m.block<1, 3>(0, 0) = axes.right_W.transpose();
  m.block<1, 3>(1, 0) = axes.up_W.transpose();
  m.block<1, 3>(2, 0) = axes.back_W.transpose();
  m.block<3, 1>(0, 3) = -m.block<3, 3>(0, 0) * view.eye_W;
  return m;
}

Eigen::Matrix4d projectionMatrix(const View& view, double aspect, double nearPlane, double farPlane) {
  const double f = 1 / std::tan(view.fieldOfView / 2);
  Eigen::Matrix4d m = Eigen::Matrix4d::Zero();
  m(0, 0) = f / aspect;
  m(1, 1) = f;
  m(2, 2) = (farPlane + nearPlane) / (nearPlane - farPlane);
  m(2, 3) = 2 * farPlane * nearPlane / (nearPlane - farPlane);
  m(3, 2) = -1;
  return m;
}

Ray rayThrough(const View& view, double x, double y, int widthPx, int heightPx) {
  const ViewAxes axes = axesOf(view);
  const double scale = 2 * std::tan(view.fieldOfView / 2) / std::max(heightPx, 1);
  const Vec3 direction =
      scale * (x - widthPx / 2.0) * axes.right_W - scale * (y - heightPx / 2.0) * axes.up_W - axes.back_W;
  return {view.eye_W, direction.normalized()};
}

std::optional<Vec2> projected(const View& view, const Vec3& p_W, int widthPx, int heightPx) {
  const ViewAxes axes = axesOf(view);
  const Vec3 d = p_W - view.eye_W;
  const double depth = -d.dot(axes.back_W);
  if (depth <= 0) return std::nullopt;
  const double scale = heightPx / (2 * std::tan(view.fieldOfView / 2)) / depth;
  return Vec2(widthPx / 2.0 + scale * d.dot(axes.right_W), heightPx / 2.0 - scale * d.dot(axes.up_W));
}

}  // namespace glenoid
