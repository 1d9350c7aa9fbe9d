// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/HapticScene.h"

#include <cmath>

#include "simcore/embed/Cells.h"
#include "simcore/mesh/GridBox.h"

namespace glenoid {

namespace {

/// Triangles about `size` long.
TriMesh boxOf(const Vec3& low, const Vec3& high, double size) {
  std::array<int, 3> cells{};
  for (std::size_t a = 0; a < 3; ++a) {
    const auto axis = static_cast<Eigen::Index>(a);
    cells[a] = std::max(1, static_cast<int>(std::lround((high[axis] - low[axis]) / size)));
  }
  return gridBox(low, high, cells);
}

Material materialOf(const char* id, double young) {
  Material material;
  material.id = material.name = id;
  material.density = 1050;
  material.youngsModulus = young;
  material.poissonRatio = 0.4;
  material.massDamping = 5;
  material.stiffnessDamping = 0.005;
  material.friction = 0;
  return material;
}

Part boxPart(const char* id, int number, PartKind kind, const Vec3& low, const Vec3& high, const char* material) {
  Part part;
  part.id = part.name = id;
  part.number = number;
  part.kind = kind;
  part.visual = part.collision = std::make_shared<const TriMesh>(boxOf(low, high, 0.005));
  part.materials = {{material, ""}};
  return part;
}

}  // namespace

const char* hapticSurfaceName(HapticSurface surface) {
  switch (surface) {
    case HapticSurface::Soft: return "soft";
    case HapticSurface::Stiff: return "stiff";
    case HapticSurface::Bone: break;
  }
  return "bone";
}

Result<std::shared_ptr<const Model>> makeHapticScene(HapticSurface surface, double stiffness, double dt, const Vec3& start) {
  const Vec3 low(-0.03, -0.02, -0.03), high(0.03, 0, 0.03);
  constexpr double kCell = 0.01;
  Joint joint;
  joint.id = joint.name = "haptic-slab";
  joint.materials = {materialOf("bone", 1e9), materialOf("tissue", surface == HapticSurface::Soft ? 20e3 : 1e6)};
  Scenario scenario;
  if (surface == HapticSurface::Bone) {
    joint.parts = {boxPart("slab", 1, PartKind::Rigid, low, high, "bone")};
    scenario.fixedParts = {"slab"};
  } else {
    Part slab = boxPart("slab", 1, PartKind::Soft, low, high, "tissue");
    Result<TetMesh> cells = embedInCells(*slab.visual, *slab.collision, kCell);
    if (!cells) return cells.error();
    slab.volume = std::make_shared<const TetMesh>(std::move(*cells));
    slab.cellSize = kCell;
    std::vector<int> base;
    for (std::size_t t = 0; t < slab.visual->triangles.size(); ++t) {
      double top = low.y();
      for (const int v : slab.visual->triangles[t]) top = std::max(top, slab.visual->vertices[static_cast<std::size_t>(v)].y());
      if (top < low.y() + 1e-9) base.push_back(static_cast<int>(t));
    }
    slab.regions = {{"base", "base", "footprint", SurfaceKind::Visual, runsOf(base)}};
    joint.parts = {std::move(slab), boxPart("plate", 2, PartKind::Rigid, low - Vec3(0, 0.02, 0), Vec3(high.x(), low.y(), high.z()), "bone")};
    joint.couplings = {{"glue", "slab", "plate", "base", 1e9, 1e-3, {}}};
    joint.exclusions = {{"slab", "plate", "glued"}};
    scenario.fixedParts = {"plate"};
  }
  scenario.id = scenario.name = std::string("haptic-") + hapticSurfaceName(surface);
  scenario.dt = dt;
  scenario.gravity_W.setZero();
  scenario.effects.friction = Wish::Off;
  Tool tool;
  tool.id = tool.name = "ball";
  tool.kind = ToolKind::Ball;
  tool.length = 0.08;
  tool.radius = 0.006;
  tool.mass = 0.05;
  tool.stiffness = stiffness;
  tool.angularStiffness = 5;
  tool.forceMax = 100;
  tool.friction = 0;
  tool.home = {start, Quat::FromTwoVectors(Vec3::UnitZ(), Vec3::UnitY())};
  scenario.tools = {tool};
  return compileModel(joint, scenario);
}

}  // namespace glenoid
