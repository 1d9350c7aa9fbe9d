// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/scenes/BlockScenes.h"

#include <cstdlib>

#include "simcore/mesh/GridBox.h"

namespace glenoid::scenes {

TriMesh boxSurface(const Vec3& low, const Vec3& high, int n) { return gridBox(low, high, {n, n, n}); }

TetMesh boxVolume(const Vec3& low, const Vec3& high, int nx, int ny, int nz) {
  TetMesh mesh;
  const auto node = [&](int x, int y, int z) { return x + (nx + 1) * (y + (ny + 1) * z); };
  for (int z = 0; z <= nz; ++z)
    for (int y = 0; y <= ny; ++y)
      for (int x = 0; x <= nx; ++x)
        mesh.nodes.push_back(low + (high - low).cwiseProduct(Vec3(double(x) / nx, double(y) / ny, double(z) / nz)));
  for (int z = 0; z < nz; ++z)
    for (int y = 0; y < ny; ++y)
      for (int x = 0; x < nx; ++x) {
        std::array<int, 8> c;
        for (int k = 0; k < 8; ++k) c[k] = node(x + (k & 1), y + (k >> 1 & 1), z + (k >> 2));
        const bool odd = (x + y + z) % 2;
        const int even4[5][4] = {{0, 1, 2, 4}, {3, 2, 1, 7}, {5, 4, 7, 1}, {6, 7, 4, 2}, {1, 2, 4, 7}};
        const int odd4[5][4] = {{1, 0, 5, 3}, {2, 3, 6, 0}, {4, 5, 0, 6}, {7, 6, 3, 5}, {0, 3, 6, 5}};
        for (const auto& tet : odd ? odd4 : even4) {
          std::array<int, 4> t{c[tet[0]], c[tet[1]], c[tet[2]], c[tet[3]]};
          mesh.tets.push_back(t);
          if (tetVolume(mesh, static_cast<int>(mesh.tets.size()) - 1) < 0) std::swap(mesh.tets.back()[0], mesh.tets.back()[1]);
        }
      }
  return mesh;
}

Part boxPart(const std::string& id, int number, PartKind kind, const Vec3& low, const Vec3& high, int cells) {
  Part part;
  part.id = id;
  part.number = number;
  part.name = id;
  part.kind = kind;
  part.visual = std::make_shared<TriMesh>(boxSurface(low, high, 4));
  part.collision = std::make_shared<TriMesh>(boxSurface(low, high, 2));
  if (kind == PartKind::Soft) {
    part.volume = std::make_shared<TetMesh>(boxVolume(low, high, cells, cells, cells));
    part.cellSize = (high - low).maxCoeff() / cells;
  }
  part.materials = {{kind == PartKind::Soft ? "tissue" : "bone", ""}};
  return part;
}

Region regionIn(const Part& part, const std::string& id, const Box3& box) {
  std::vector<int> triangles;
  for (std::size_t t = 0; t < part.visual->triangles.size(); ++t) {
    Vec3 centroid = Vec3::Zero();
    for (const int v : part.visual->triangles[t]) centroid += part.visual->vertices[v] / 3;
    if (box.contains(centroid)) triangles.push_back(static_cast<int>(t));
  }
  return {id, id, "footprint", SurfaceKind::Visual, runsOf(triangles)};
}

std::optional<Elements> wishedElements() {
  const char* wish = std::getenv("GLENOID_ELEMENTS");
  if (!wish || std::string(wish) != "cells") return std::nullopt;
  return Elements::Cells;
}

void addMaterials(Joint& joint) {
  Material bone;
  bone.id = bone.name = "bone";
  bone.density = 2000;
  Material tissue;
  tissue.id = tissue.name = "tissue";
  tissue.density = 1000;
  tissue.youngsModulus = 5e4;
  tissue.poissonRatio = 0.4;
  tissue.stiffnessDamping = 1e-3;
  joint.materials = {bone, tissue};
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
