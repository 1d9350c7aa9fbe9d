// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/scenes/BlockScenes.h"

#include <cstdlib>

namespace glenoid::scenes {

std::optional<Elements> wishedElements() {
  const char* wish = std::getenv("GLENOID_ELEMENTS");
  if (!wish || std::string(wish) != "cells") return std::nullopt;
  return Elements::Cells;
}

Joint figure4Joint() {
  Joint joint;
  joint.id = joint.name = "figure4";
  addMaterials(joint);
  joint.parts.push_back(boxPart("left", 1, PartKind::Rigid, Vec3(-0.05, 0, 0), Vec3(-0.02, 0.02, 0.02)));
  joint.parts.push_back(boxPart("middle", 2, PartKind::Soft, Vec3(-0.02, 0, 0), Vec3(0.02, 0.02, 0.02)));
  joint.parts.push_back(boxPart("right", 3, PartKind::Rigid, Vec3(0.02, 0, 0), Vec3(0.05, 0.02, 0.02)));
  Part& middle = joint.parts[1];
  middle.regions.push_back(regionIn(middle, "left-end", Box3(Vec3(-0.0201, -1, -1), Vec3(-0.0199, 1, 1))));
  middle.regions.push_back(regionIn(middle, "right-end", Box3(Vec3(0.0199, -1, -1), Vec3(0.0201, 1, 1))));
  joint.couplings.push_back({"c12", "middle", "left", "left-end", 1e8, 1e-3});
  joint.couplings.push_back({"c23", "middle", "right", "right-end", 1e8, 1e-3});
  return joint;
}

Scenario figure4Scenario() {
  Scenario scenario;
  scenario.id = scenario.name = "figure4";
  scenario.elements = wishedElements();
  scenario.fixedParts = {"left"};
  return scenario;
}

Scenario figure5Scenario() {
  Scenario scenario;
  scenario.id = scenario.name = "figure5";
  scenario.elements = wishedElements();
  scenario.gravity_W.setZero();
  for (const double x : {-0.008, 0.008}) {
    Tool tool;
    tool.id = tool.name = x < 0 ? "first" : "second";
    tool.kind = ToolKind::Finger;
    tool.length = 0.05;
    tool.radius = 0.004;
    tool.home.p_WB = Vec3(x, 0.0205, 0.01);
    tool.home.q_WB = Quat::FromTwoVectors(Vec3::UnitZ(), Vec3::UnitY());
    scenario.tools.push_back(tool);
  }
  return scenario;
}

Joint blockOnPlateJoint() {
  Joint joint;
  joint.id = joint.name = "block";
  addMaterials(joint);
  joint.parts.push_back(boxPart("plate", 1, PartKind::Rigid, Vec3(-0.05, -0.01, -0.05), Vec3(0.05, 0, 0.05)));
  joint.parts.push_back(boxPart("block", 2, PartKind::Soft, Vec3(-0.02, 0.0005, -0.02), Vec3(0.02, 0.0405, 0.02)));
  return joint;
}

Scenario blockOnPlateScenario() {
  Scenario scenario;
  scenario.id = scenario.name = "block";
  scenario.elements = wishedElements();
  scenario.fixedParts = {"plate"};
  Tool tool;
  tool.id = tool.name = "finger";
  tool.kind = ToolKind::Finger;
  tool.length = 0.06;
  tool.radius = 0.006;
  tool.home.p_WB = Vec3(0, 0.06, 0);
  tool.home.q_WB = Quat::FromTwoVectors(Vec3::UnitZ(), Vec3::UnitY());
  scenario.tools = {tool};
  return scenario;
}

Joint sunkenCubesJoint() {
  Joint joint;
  joint.id = joint.name = "sunken-cubes";
  addMaterials(joint);
  joint.parts.push_back(boxPart("slab", 1, PartKind::Rigid, {-0.06, -0.02, -0.03}, {0.06, 0, 0.03}));
  const char* const names[] = {"deep", "middle", "shallow"};
  for (int i = 0; i < 3; ++i) {
    const Vec3 low(-0.045 + 0.035 * i, -kCubeDepths[i], -0.01);
    joint.parts.push_back(boxPart(names[i], 2 + i, PartKind::Rigid, low, low + Vec3::Constant(0.02)));
  }
  return joint;
}

Scenario sunkenCubesScenario() {
  Scenario scenario;
  scenario.id = scenario.name = "sunken-cubes";
  scenario.fixedParts = {"slab"};
  scenario.effects.gravity = Wish::Off;
  scenario.recoverySpeedMax = kRecovery;
  return scenario;
}

}  // namespace glenoid::scenes
