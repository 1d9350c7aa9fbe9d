// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/tool/ToolBalls.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simcore/base/PlainMath.h"

namespace glenoid {

namespace {

/// Balls between two, the first of them included.
void sweep(const ToolBall& from, const ToolBall& to, std::vector<ToolBall>& balls) {
  const double least = std::min(from.radius, to.radius);
  const int count = std::max(1, static_cast<int>(std::ceil((to.centre_T - from.centre_T).norm() / (0.5 * least))));
  for (int i = 0; i < count; ++i) {
    const double share = static_cast<double>(i) / count;
    balls.push_back({from.centre_T + share * (to.centre_T - from.centre_T), from.radius + share * (to.radius - from.radius)});
  }
}

/// Balls through all of these.
std::vector<ToolBall> sweep(const std::vector<ToolBall>& path) {
  std::vector<ToolBall> balls;
  for (std::size_t i = 0; i + 1 < path.size(); ++i) sweep(path[i], path[i + 1], balls);
  balls.push_back(path.back());
  return balls;
}

std::vector<ToolBall> straight(const Tool& tool, double tip, double taper) {
  const double full = tool.radius, end = std::max(tool.length, 2 * tip), wide = std::clamp(taper, 1.5 * tip, end);
  const Vec3 z = Vec3::UnitZ();
  return sweep({{tip * z, tip}, {wide * z, full}, {end * z, full}});
}

/// Sizes as in ToolShape's hook: along X, a quarter of a bend, then the shaft. The first ball goes through the end's point and its
/// first ring, the second through both rings.
std::vector<ToolBall> hooked(const Tool& tool) {
  const double radius = tool.radius, bend = 2 * radius, reach = 0.004;
  std::vector<ToolBall> path = {{Vec3(bend + reach - 4.0 / 15 * radius, 0, radius), 17.0 / 30 * radius},
                                {Vec3(bend + reach - 0.6875 * radius, 0, radius), 0.85 * radius},
                                {Vec3(bend, 0, radius), radius}};
  for (const double turn : {0.25, 0.5, 0.75, 1.0}) {
    const double angle = turn * std::numbers::pi / 2;
    path.push_back({Vec3(bend * (1 - plain::sine(angle)), 0, radius + bend * (1 - plain::cosine(angle))), radius});
  }
  path.push_back({Vec3(0, 0, std::max(tool.length, radius + 2 * bend)), radius});
  return sweep(path);
}

std::vector<ToolBall> ballOnShaft(const Tool& tool) {
  const double shaft = 0.25 * tool.radius, neck = 2 * tool.radius;
  std::vector<ToolBall> balls = {{tool.radius * Vec3::UnitZ(), tool.radius}};
  const std::vector<ToolBall> behind = sweep({{neck * Vec3::UnitZ(), shaft}, {std::max(tool.length, 1.1 * neck) * Vec3::UnitZ(), shaft}});
  balls.insert(balls.end(), behind.begin(), behind.end());
  return balls;
}

}  // namespace

std::vector<ToolBall> makeToolBalls(const Tool& tool) {
  switch (tool.kind) {
    case ToolKind::Probe: return hooked(tool);
    case ToolKind::Arthroscope: return straight(tool, tool.radius, tool.radius);
    case ToolKind::Finger: return straight(tool, 0.75 * tool.radius, 0.4 * tool.length);
    case ToolKind::Ball: return ballOnShaft(tool);
    case ToolKind::Bar: return {};
  }
  return {};
}

}  // namespace glenoid
