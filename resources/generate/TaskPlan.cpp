// SPDX-License-Identifier: GPL-3.0-or-later
#include "resources/generate/TaskPlan.h"

#include <algorithm>
#include <cstdio>

#include "resources/generate/PressPlan.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid::generate {
namespace {

constexpr double kBegin = 1.5;    ///< s: one second to settle, half a second that counts as rest
constexpr double kAway = 0.035;   ///< m: over the skin between two places
constexpr double kRetreat = 0.06; ///< m: along the way in, before and after a touch
constexpr double kRound = 0.15;   ///< m: how far from the joint a tool goes from one place to the next

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

/// By the roomiest of the ways in from all sides, the shown one first among equals; between two places far out, round the joint.
void addPress(const Joint& joint, const Task& task, const Tool& tool, const Vec3& preferred_W, double depth, double& time, HandTrack& track,
              std::vector<RecordingMark>& marks) {
  const TaskPlace& place = task.places[0];
  Approach way;
  double best = -1e300;
  for (const Vec3& from : {preferred_W, Vec3(0.4, 0.2, 0.9), Vec3(0.2, 0.9, 0.4), Vec3(-0.9, 0.1, 0.4), Vec3(0.9, -0.4, 0.1)}) {
    const Approach found = findApproach(joint, tool, {task.id, place.part, place.region, depth}, from.normalized());
    const double room = std::min(found.clearance, 2e-3) + (from == preferred_W ? 2e-4 : 0);
    if (room > best) best = room, way = found;
  }
  const auto key = [&](double at, const Vec3& tip, const Quat& turn) { track.keys.push_back({at, {tip, turn.normalized()}}); };
  const Pose from = track.keys.back().hand;
  const Vec3 away = way.tip_W + kRetreat * way.outward_W, far = kRound * (way.tip_W + 2 * kRetreat * way.outward_W).normalized();
  const Vec3 before = kRound * (from.p_WB + 0.5 * kRetreat * (from.q_WB * Vec3::UnitZ())).normalized();
  key(time + 0.4, before, from.q_WB);
  // Over the sphere: along the great circle, the middle first.
  Vec3 middle = before + far;
  middle = middle.norm() > 1e-3 ? Vec3(kRound * middle.normalized()) : Vec3(0, kRound, 0);
  key(time + 0.8, middle, from.q_WB.slerp(0.5, way.q_WT));
  key(time + 1.2, far, way.q_WT);
  key(time + 1.5, away, way.q_WT);
  key(time + 2.2, way.tip_W + 3e-3 * way.outward_W, way.q_WT);
  key(time + 3.0, way.tip_W - depth * way.outward_W, way.q_WT);
  key(time + 3.8, way.tip_W - depth * way.outward_W, way.q_WT);
  key(time + 4.3, away, way.q_WT);
  std::printf("%-20s clearance %.1f mm from %.2f %.2f %.2f\n", task.id.c_str(), 1e3 * way.clearance, way.outward_W.x(), way.outward_W.y(), way.outward_W.z());
  marks.push_back({task.id, time + 3.0, time + 3.8, {}, {}});
  time += 4.3;
}

}  // namespace

Recording planTasks(const Joint& joint, const Scenario& scenario, const std::string& toolId, const Vec3& preferred_W, double depth) {
  const Tool& tool = scenario.tools[findTool(scenario, toolId)];
  Recording recording;
  recording.dt = scenario.dt;
  HandTrack track{toolId, {{kBegin, tool.home}}};
  double time = kBegin;
  for (const Task& task : scenario.training.tasks) {
    if (task.kind == TaskKind::Touch || task.kind == TaskKind::Press) addPress(joint, task, tool, preferred_W, depth, time, track, recording.marks);
    if (task.kind == TaskKind::Find) addFind(joint, task, tool, depth, time, track, recording.marks);
  }
  track.keys.push_back({time + 0.8, tool.home});
  recording.tracks.push_back(std::move(track));
  return recording;
}

}  // namespace glenoid::generate
