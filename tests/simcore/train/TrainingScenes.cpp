// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simcore/train/TrainingScenes.h"

#include <gtest/gtest.h>

#include "tests/scenes/BlockScenes.h"

namespace glenoid::scenes {

Joint slabJoint() {
  Joint joint;
  joint.id = joint.name = "slab-joint";
  addMaterials(joint);
  Part slab = boxPart("slab", 1, PartKind::Rigid, Vec3(-0.06, -0.02, -0.03), Vec3(0.06, 0, 0.03));
  slab.landmarks = {{"left", "Left", Vec3(-0.03, 0, 0)}, {"middle", "Middle", Vec3::Zero()}, {"right", "Right", Vec3(0.03, 0, 0)}, {"below", "Below", Vec3(0.02, -0.01, 0)}};
  slab.regions.push_back(regionIn(slab, "right-half", Box3(Vec3(0, -1e-3, -1), Vec3(1, 1e-3, 1))));
  joint.parts.push_back(std::move(slab));
  return joint;
}

Scenario slabScenario() {
  Scenario scenario;
  scenario.id = scenario.name = "slab";
  scenario.fixedParts = {"slab"};
  scenario.effects.gravity = Wish::Off;
  Tool finger;
  finger.id = finger.name = "finger";
  finger.kind = ToolKind::Finger;
  finger.length = 0.06;
  finger.radius = 0.006;
  finger.home = upright(Vec3(0, 0.04, 0));
  Tool scope;
  scope.id = scope.name = "scope";
  scope.kind = ToolKind::Arthroscope;
  scope.lens = 0.5235987755982988;
  scope.home = upright(Vec3(-0.03, 0.04, 0));
  scenario.tools = {finger, scope};
  return scenario;
}

Pose upright(const Vec3& tip_W) { return {tip_W, Quat::FromTwoVectors(Vec3::UnitZ(), Vec3::UnitY())}; }

HandTrack handThrough(const Scenario& scenario, const std::string& tool, const std::vector<HandStop>& stops) {
  const Pose& home = scenario.tools.at(static_cast<std::size_t>(findTool(scenario, tool))).home;
  HandTrack track{tool, {{0, home}, {0.5, home}}};
  for (const HandStop& stop : stops) {
    const double there = track.keys.back().time + stop.seconds;
    track.keys.push_back({there, {stop.tip_W, home.q_WB}});
    if (stop.rest > 0) track.keys.push_back({there + stop.rest, {stop.tip_W, home.q_WB}});
  }
  return track;
}

RunResult trainingRun(const Scenario& scenario, const Recording& input, bool trace) {
  const auto model = compileModel(slabJoint(), scenario);
  if (!model) {
    ADD_FAILURE() << toLogLine(model.error());
    return {};
  }
  RunOptions options;
  options.seconds = inputSeconds(input);
  options.input = &input;
  options.checks = false;
  options.trainingTrace = trace;
  Result<RunResult> result = runScenario(*model, options);
  if (!result) {
    ADD_FAILURE() << toLogLine(result.error());
    return {};
  }
  return *result;
}

Task taskAt(const std::string& id, TaskKind kind, const std::string& landmark) {
  Task task;
  task.id = id;
  task.kind = kind;
  task.tool = kind == TaskKind::Look ? "scope" : "finger";
  TaskPlace place;
  place.part = "slab";
  place.landmark = landmark;
  task.places = {place};
  return task;
}

}  // namespace glenoid::scenes
