// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/generate/StrokePlan.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glenoid::generate {

Recording planStrokes(const Scenario& scenario, const std::string& toolId, const std::string& partId) {
  constexpr double kStroke = 0.015, kCircle = 0.025;        // m
  constexpr double kTurn = 2 * std::numbers::pi * kCircle / 0.5;  // s for one circle
  const Tool& tool = scenario.tools[findTool(scenario, toolId)];
  const Vec3 out = tool.home.q_WB * Vec3::UnitZ(), up = (Vec3::UnitY() - out.y() * out).normalized(), front = up.cross(out);
  HandTrack track;
  track.tool = toolId;
  const auto key = [&](double time, double depth, double along, double across) {
    track.keys.push_back({time, {tool.home.p_WB - depth * out + along * up + across * front, tool.home.q_WB}});
  };
  key(0.5, 0, 0, 0);
  key(1.0, 0.012, 0, 0);
  key(1.5, 0.018, 0, 0);
  key(2.5, 0.018, 0, 0);
  for (int i = 1; i <= 40; ++i) key(2.5 + 0.05 * i, 0.020, kStroke * std::sin(0.1 * std::numbers::pi * i), 0);
  constexpr int kTurns = 6, kPerTurn = 12;
  for (int i = 1; i <= kTurns * kPerTurn; ++i) {
    // Wider from nothing in the first turn, back to nothing in the last.
    const double wide = kCircle * std::min({1.0, double(i) / kPerTurn, double(kTurns * kPerTurn - i) / kPerTurn});
    const double angle = 2 * std::numbers::pi * i / kPerTurn;
    key(4.5 + kTurn * i / kPerTurn, 0.022, wide * std::sin(angle), wide * std::cos(angle));
  }
  const double end = 4.5 + kTurn * kTurns;
  key(end + 0.3, 0.010, 0, 0);
  key(end + 0.6, -0.010, 0, 0);
  key(8, -0.010, 0, 0);

  Recording recording;
  recording.dt = scenario.dt;
  recording.marks = {{"press", 1.5, 2.5, toolId, partId},
                     {"stroke", 2.5, 4.5, toolId, partId},
                     {"circle", 4.5 + kTurn, end - kTurn, toolId, partId}};
  recording.tracks.push_back(std::move(track));
  return recording;
}

}  // namespace glenoid::generate
