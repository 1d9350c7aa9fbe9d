// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/hard/HardScenes.h"

namespace glenoid::hard {

Material tissue(const std::string& id, double youngsModulus, double poissonRatio, double density, double stiffnessDamping) {
  Material material;
  material.id = material.name = id;
  material.youngsModulus = youngsModulus;
  material.poissonRatio = poissonRatio;
  material.density = density;
  material.stiffnessDamping = stiffnessDamping;
  return material;
}

Part box(const std::string& id, int number, PartKind kind, const std::string& material, const Vec3& low, const Vec3& high,
         int cells, int surface) {
  Part part = scenes::boxPart(id, number, kind, low, high, cells);
  part.collision = std::make_shared<TriMesh>(scenes::boxSurface(low, high, surface));
  part.materials = {{material, ""}};
  return part;
}

void couple(Joint& joint, const std::string& a, int axis, int side, const std::string& b, double stiffness, double damping) {
  Part& part = joint.parts[findPart(joint, a)];
  const Box3 bounds = boundsOf(*part.visual);
  const double at = side ? bounds.max()[axis] : bounds.min()[axis];
  Vec3 low = Vec3::Constant(-1e3), high = Vec3::Constant(1e3);
  low[axis] = at - 1e-7;
  high[axis] = at + 1e-7;
  const Region region = scenes::regionIn(part, "to-" + b, Box3(low, high));
  part.regions.push_back(region);
  const double area = areaOf(part, region);
  joint.couplings.push_back({a + "-" + b, a, b, region.id, stiffness / area, damping});
}

Tool finger(const Vec3& tip, double length, double radius) {
  Tool tool;
  tool.id = tool.name = "finger";
  tool.kind = ToolKind::Finger;
  tool.length = length;
  tool.radius = radius;
  tool.home.p_WB = tip;
  tool.home.q_WB = Quat::FromTwoVectors(Vec3::UnitZ(), Vec3::UnitY());
  return tool;
}

Pose handAt(const Tool& tool, const Vec3& tip) { return {tip, tool.home.q_WB}; }

HardCase fingerOverBlock(const std::string& name) {
  HardCase hard;
  hard.name = name;
  hard.joint = scenes::blockOnPlateJoint();
  hard.scenario = scenes::blockOnPlateScenario();
  hard.joint.materials[1].stiffnessDamping = 5e-3;  // settles within a second, so that two are a fair bound
  hard.joint.materials[1].massDamping = 5;          // 1/s: joint fluid; without it a pushed block would slide for ever
  return hard;
}

}  // namespace glenoid::hard
