// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/render/Marker.h"

#include <algorithm>
#include <array>

namespace glenoid {
namespace {

/// Strokes in a box of width 2 (−1…1) and height 2, as pairs of points.
std::vector<std::array<float, 4>> strokesOf(char letter) {
  switch (letter) {
    case 'A':
      return {{-0.8f, -1, 0, 1}, {0, 1, 0.8f, -1}, {-0.5f, -0.25f, 0.5f, -0.25f}};
    case 'P':
      return {{-0.6f, -1, -0.6f, 1},      {-0.6f, 1, 0.3f, 1},    {0.3f, 1, 0.7f, 0.75f},
              {0.7f, 0.75f, 0.7f, 0.25f}, {0.7f, 0.25f, 0.3f, 0}, {0.3f, 0, -0.6f, 0}};
    case 'S':
      return {{0.7f, 0.7f, 0.3f, 1},        {0.3f, 1, -0.3f, 1},          {-0.3f, 1, -0.7f, 0.75f},
              {-0.7f, 0.75f, -0.7f, 0.35f}, {-0.7f, 0.35f, 0.7f, -0.35f}, {0.7f, -0.35f, 0.7f, -0.75f},
              {0.7f, -0.75f, 0.3f, -1},     {0.3f, -1, -0.3f, -1},        {-0.3f, -1, -0.7f, -0.7f}};
    case 'I':
      return {{0, -1, 0, 1}, {-0.4f, 1, 0.4f, 1}, {-0.4f, -1, 0.4f, -1}};
    case 'L':
      return {{-0.5f, 1, -0.5f, -1}, {-0.5f, -1, 0.6f, -1}};
    case 'M':
      return {{-0.8f, -1, -0.8f, 1}, {-0.8f, 1, 0, -0.2f}, {0, -0.2f, 0.8f, 1}, {0.8f, 1, 0.8f, -1}};
    default:
      return {};
  }
}

struct Arm {
  Vec3 direction_W;  ///< of a right joint
  char letter;
  std::array<float, 3> onLight, onDark;  ///< sRGB
};

}  // namespace

MarkerLines markerLines(const View& view, double sizePx, bool dark, JointSide side) {
  static const Arm kArms[] = {{Vec3::UnitX(), 'A', {0.76f, 0.20f, 0.18f}, {0.96f, 0.45f, 0.41f}},
                              {-Vec3::UnitX(), 'P', {0.76f, 0.20f, 0.18f}, {0.96f, 0.45f, 0.41f}},
                              {Vec3::UnitY(), 'S', {0.16f, 0.50f, 0.22f}, {0.50f, 0.82f, 0.50f}},
                              {-Vec3::UnitY(), 'I', {0.16f, 0.50f, 0.22f}, {0.50f, 0.82f, 0.50f}},
                              {Vec3::UnitZ(), 'L', {0.14f, 0.36f, 0.72f}, {0.47f, 0.69f, 0.98f}},
                              {-Vec3::UnitZ(), 'M', {0.14f, 0.36f, 0.72f}, {0.47f, 0.69f, 0.98f}}};
  const ViewAxes axes = axesOf(view);
  struct Seen {
    const Arm* arm;
    Vec3 at;  ///< right, up, towards the viewer
  };
  std::vector<Seen> seen;
  for (const Arm& arm : kArms) {
    Vec3 direction_W = arm.direction_W;
    direction_W.z() *= lateralSign(side);
    seen.push_back({&arm, Vec3(direction_W.dot(axes.right_W), direction_W.dot(axes.up_W), direction_W.dot(axes.back_W))});
  }
  std::stable_sort(seen.begin(), seen.end(),
                   [](const Seen& a, const Seen& b) { return a.at.z() < b.at.z(); });

  MarkerLines out;
  const float size = static_cast<float>(sizePx), arm = 0.29f * size, letter = 0.065f * size;
  const Eigen::Vector2f middle(0.56f * size, 0.56f * size);
  for (const Seen& s : seen) {
    const std::array<float, 3>& c = dark ? s.arm->onDark : s.arm->onLight;
    const bool positive = s.arm->letter == 'A' || s.arm->letter == 'S' || s.arm->letter == 'L';
    // What points away from the viewer is paler.
    const float alpha = static_cast<float>((positive ? 0.78 : 0.50) + 0.22 * s.at.z());
    const Eigen::Vector2f direction(static_cast<float>(s.at.x()), static_cast<float>(s.at.y()));
    const auto put = [&](std::vector<ColoredPoint>& to, const Eigen::Vector2f& p, float a) {
      to.push_back({Eigen::Vector3f(p.x(), p.y(), 0), Eigen::Vector4f(c[0], c[1], c[2], a)});
    };
    put(out.axes, middle, positive ? alpha : 0.4f * alpha);
    put(out.axes, middle + arm * direction, positive ? alpha : 0.4f * alpha);
    // An arm along the gaze has its letter in the middle; only the nearer of the two is written.
    if (direction.norm() < 0.25f && s.at.z() < 0) continue;
    const Eigen::Vector2f at = middle + (arm + 1.9f * letter) * direction;
    for (const auto& stroke : strokesOf(s.arm->letter)) {
      put(out.letters, at + letter * Eigen::Vector2f(0.8f * stroke[0], stroke[1]), alpha);
      put(out.letters, at + letter * Eigen::Vector2f(0.8f * stroke[2], stroke[3]), alpha);
    }
  }
  return out;
}

}  // namespace glenoid
