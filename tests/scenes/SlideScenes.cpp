// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/scenes/SlideScenes.h"

#include <cmath>
#include <random>

#include "tests/scenes/BlockScenes.h"

namespace glenoid::scenes {

namespace {

/// Moves vertices that lie inside the level face at height y, by up to `scatter` of a cell within it and `heights` across.
void roughen(TriMesh& mesh, double y, int cells, double scatter, double heights, std::mt19937& random) {
  const Box3 box = boundsOf(mesh);
  const Vec3 cell = box.sizes() / cells;
  std::uniform_real_distribution<double> any(-1, 1);
  for (Vec3& x : mesh.vertices) {
    const double inset = std::min({x.x() - box.min().x(), box.max().x() - x.x(), x.z() - box.min().z(), box.max().z() - x.z()});
    if (std::abs(x.y() - y) > 1e-9 * box.sizes().maxCoeff() || inset < 1e-6 * box.sizes().maxCoeff()) continue;
    x += Vec3(any(random) * scatter * cell.x(), any(random) * heights, any(random) * scatter * cell.z());
  }
}

void turnAbout(TriMesh& mesh, const Vec3& centre, double angle) {
  const Mat3 R = Eigen::AngleAxisd(angle, Vec3::UnitY()).toRotationMatrix();
  for (Vec3& x : mesh.vertices) x = centre + R * (x - centre);
}

/// The lower face pulled in, so that a bevel of 45° leads up to the sides: the lowest ring of cells is `bevel` high.
void bevelBelow(TriMesh& mesh, int cells, double bevel) {
  const Box3 box = boundsOf(mesh);
  const double second = box.min().y() + box.sizes().y() / cells;
  for (Vec3& x : mesh.vertices) {
    if (x.y() < box.min().y() + 0.1 * (second - box.min().y())) {
      for (const int axis : {0, 2}) {
        const double middle = box.center()[axis], half = box.sizes()[axis] / 2;
        x[axis] = middle + (x[axis] - middle) * (half - bevel) / half;
      }
    } else if (std::abs(x.y() - second) < 0.1 * (second - box.min().y())) {
      x.y() = box.min().y() + bevel;
    }
  }
}

}  // namespace

Joint slideJoint(const Slide& slide) {
  Joint joint;
  joint.id = joint.name = "slide";
  addMaterials(joint);
  joint.materials[1].youngsModulus = 2e5 * slide.scale;
  joint.materials[1].massDamping = 0;
  for (Material& material : joint.materials) material.friction = slide.friction;
  std::mt19937 random(slide.seed);
  const double s = slide.scale;
  const bool softPlate = slide.plate == PartKind::Soft;
  const Vec3 low = s * Vec3(-0.1, -0.01, -0.15), high = s * Vec3(0.5, 0, 0.15);
  Part plate = boxPart("plate", 1, slide.plate, low, high, 1);
  TriMesh top = boxSurface(low, high, slide.cells);
  roughen(top, 0, slide.cells, slide.scatter, slide.heights, random);
  if (!softPlate) turnAbout(top, s * Vec3(0.2, 0, 0), slide.turn);
  plate.collision = std::make_shared<TriMesh>(top);
  if (softPlate) {
    plate.volume = std::make_shared<TetMesh>(boxVolume(low, high, 16, 1, 8));
    plate.cellSize = s * 0.0375;
  }
  const Vec3 from = s * Vec3(-0.02, 1e-6, -0.015), to = s * Vec3(0.02, 0.01, 0.015);
  Part block = boxPart("block", 2, slide.block, from, to, 2);
  constexpr int kBlockCells = 3;
  TriMesh bottom = boxSurface(from, to, kBlockCells);
  roughen(bottom, from.y(), kBlockCells, slide.scatter, 0, random);
  if (slide.bevel > 0) bevelBelow(bottom, kBlockCells, slide.bevel);
  block.collision = std::make_shared<TriMesh>(bottom);
  if (slide.block == PartKind::Soft) block.volume = std::make_shared<TetMesh>(boxVolume(from, to, 4, 1, 3));
  joint.parts = {plate, block};
  if (softPlate) {
    joint.parts.push_back(boxPart("base", 3, PartKind::Rigid, low - s * Vec3(0, 0.01, 0), Vec3(high.x(), low.y(), high.z())));
    Part& sheet = joint.parts[0];
    sheet.visual = std::make_shared<TriMesh>(boxSurface(low, high, 16));  // a spring at each node below
    sheet.regions.push_back(regionIn(sheet, "below", Box3(low - s * Vec3::Constant(1), Vec3(s, low.y() + 1e-6 * s, s))));
    joint.couplings.push_back({"glue", "plate", "base", "below", 1e8, 1e-3, ""});
    joint.exclusions.push_back({"plate", "base", ""});
    joint.exclusions.push_back({"base", "block", ""});
  }
  return joint;
}

Scenario slideScenario(const Slide& slide) {
  Scenario scenario;
  scenario.id = scenario.name = "slide";
  scenario.fixedParts = {slide.plate == PartKind::Soft ? "base" : "plate"};
  scenario.dt = slide.dt;
  scenario.contactDistance *= slide.scale;
  scenario.recoverySpeedMax *= slide.scale;
  scenario.gravity_W = slide.scale * kSlideGravity * Vec3(std::sin(slide.angle), -std::cos(slide.angle), 0);
  return scenario;
}

double slideSpeed(const Slide& slide, double time) {
  return slide.scale * kSlideGravity * (std::sin(slide.angle) - slide.friction * std::cos(slide.angle)) * time;
}

}  // namespace glenoid::scenes
