// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/generate/TaskPlan.h"

#include <algorithm>

#include "resources/generate/PressPlan.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid::generate {
namespace {

constexpr double kBegin = 1.5;    ///< s: one second to settle, half a second that counts as rest
constexpr double kAway = 0.035;   ///< m: over the skin between two places

Vec3 restOf(const Joint& joint, const TaskPlace& place) {
  if (place.point_W) return *place.point_W;
  const Part& part = joint.parts[findPart(joint, place.part)];
  const auto found = std::find_if(part.landmarks.begin(), part.landmarks.end(), [&](const Landmark& entry) { return entry.id == place.landmark; });
  return found == part.landmarks.end() ? Vec3(Vec3::Zero()) : found->position_W;
}

/// Over the place, in, still, out.
void addFind(const Joint& joint, const Task& task, const Tool& tool, double depth, double& time, HandTrack& track, std::vector<RecordingMark>& marks) {
  const Part& skin = joint.parts[findPart(joint, "skin")];
  const Vec3 place = restOf(joint, task.places[0]);
  const TriangleTree tree(*skin.visual);
  const TriangleTree::Closest closest = tree.closest(place);
  const Vec3 out = (closest.point - place).normalized();
  const Quat turn = Quat::FromTwoVectors(Vec3::UnitZ(), out);
  const auto key = [&](double at, double height) { track.keys.push_back({at, {closest.point + height * out, turn}}); };
  key(time + 0.8, kAway);
  key(time + 1.4, 0.002);
  key(time + 1.9, -depth);
  key(time + 1.9 + task.hold + 0.6, -depth);
  key(time + 2.4 + task.hold + 0.6, kAway);
  marks.push_back({task.id, time + 1.9, time + 2.5 + task.hold, tool.id, "skin"});
  time += 3.0 + task.hold;
}

}  // namespace

Recording planTasks(const Joint& joint, const Scenario& scenario, const std::string& toolId, const Vec3& preferred_W, double depth) {
  const Tool& tool = scenario.tools[findTool(scenario, toolId)];
  std::vector<PressTarget> presses;
  Recording recording;
  recording.dt = scenario.dt;
  HandTrack finds{toolId, {{kBegin, tool.home}}};
  double time = kBegin;
  for (const Task& task : scenario.training.tasks) {
    const TaskPlace& place = task.places[0];
    if (task.kind == TaskKind::Touch || task.kind == TaskKind::Press) presses.push_back({task.id, place.part, place.region, depth});
    if (task.kind == TaskKind::Find) addFind(joint, task, tool, depth, time, finds, recording.marks);
  }
  if (!presses.empty()) return planPresses(joint, scenario, toolId, presses, preferred_W, kBegin);
  finds.keys.push_back({time + 0.5, tool.home});
  recording.tracks.push_back(std::move(finds));
  return recording;
}

}  // namespace glenoid::generate
