// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/truth/TruthMotions.h"

#include <cmath>
#include <random>

namespace glenoid::truth {

TruthScene twoFallingBoxes() {
  TruthScene scene = namedScene("falling");
  scene.joint.parts.push_back(boxPart("hard", 1, PartKind::Rigid, Vec3(-0.2, 0, 0), Vec3(-0.17, 0.02, 0.05)));
  scene.joint.parts.push_back(boxPart("soft", 2, PartKind::Soft, Vec3(0.2, 0, 0), Vec3(0.23, 0.02, 0.05)));
  return scene;
}

TruthScene twoBoxesOnASpring(double stiffness) {
  TruthScene scene = namedScene("spring");
  scene.joint.parts.push_back(plainBox("first", 1, Vec3(-0.04, -0.01, -0.01), Vec3(0, 0.01, 0.01)));
  scene.joint.parts.push_back(plainBox("second", 2, Vec3(0, -0.01, -0.01), Vec3(0.03, 0.01, 0.01)));
  scene.joint.parts[0].regions.push_back(regionIn(scene.joint.parts[0], "face", levelAt(0, 0)));
  scene.joint.couplings.push_back({"spring", "first", "second", "face", stiffness / 4e-4, 0});
  scene.scenario.effects.gravity = scene.scenario.effects.contact = Wish::Off;
  return scene;
}

TruthScene hangingBar(int cells, double youngsModulus, double density) {
  TruthScene scene = namedScene("bar");
  Material& tissue = scene.joint.materials[1];
  tissue.youngsModulus = youngsModulus;
  tissue.poissonRatio = 0;
  tissue.density = density;
  const Vec3 low(-0.01, -0.1, -0.01), high(0.01, 0, 0.01);
  scene.joint.parts.push_back(
      boxPart("plate", 1, PartKind::Rigid, Vec3(-0.02, 0, -0.02), Vec3(0.02, 0.01, 0.02)));
  Part bar = boxPart("bar", 2, PartKind::Soft, low, high);
  bar.visual = std::make_shared<TriMesh>(boxSurface(low, high, 4 * cells));
  bar.volume = std::make_shared<TetMesh>(boxVolume(low, high, cells, 5 * cells, cells));
  bar.regions.push_back(regionIn(bar, "top", levelAt(1, 0)));
  scene.joint.parts.push_back(bar);
  scene.joint.couplings.push_back({"glue", "bar", "plate", "top", 1e10, 0});
  scene.scenario.fixedParts = {"plate"};
  scene.scenario.effects.contact = Wish::Off;
  return scene;
}

namespace {

/// Moves vertices that lie inside the level face at height y, by up to `scatter` of a cell within it and
/// `heights` across.
void roughen(TriMesh& mesh, double y, int cells, double scatter, double heights, std::mt19937& random) {
  const Box3 box = boundsOf(mesh);
  const Vec3 cell = box.sizes() / cells;
  std::uniform_real_distribution<double> any(-1, 1);
  for (Vec3& x : mesh.vertices) {
    const double inset = std::min(
        {x.x() - box.min().x(), box.max().x() - x.x(), x.z() - box.min().z(), box.max().z() - x.z()});
    if (std::abs(x.y() - y) > 1e-9 * box.sizes().maxCoeff() || inset < 1e-6 * box.sizes().maxCoeff())
      continue;
    x += Vec3(any(random) * scatter * cell.x(), any(random) * heights, any(random) * scatter * cell.z());
  }
}

void turnAbout(TriMesh& mesh, const Vec3& centre, double angle) {
  const Mat3 R = Eigen::AngleAxisd(angle, Vec3::UnitY()).toRotationMatrix();
  for (Vec3& x : mesh.vertices) x = centre + R * (x - centre);
}

/// The lower face pulled in, so that a bevel of 45° leads up to the sides: the lowest ring of cells is
/// `bevel` high.
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
    joint.parts.push_back(
        boxPart("base", 3, PartKind::Rigid, low - s * Vec3(0, 0.01, 0), Vec3(high.x(), low.y(), high.z())));
    Part& sheet = joint.parts[0];
    sheet.visual = std::make_shared<TriMesh>(boxSurface(low, high, 16));  // a spring at each node below
    sheet.regions.push_back(
        regionIn(sheet, "below", Box3(low - s * Vec3::Constant(1), Vec3(s, low.y() + 1e-6 * s, s))));
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
  return slide.scale * kSlideGravity * (std::sin(slide.angle) - slide.friction * std::cos(slide.angle)) *
         time;
}

TruthScene stickSlip(const StickSlip& wish, double dt) {
  TruthScene scene = namedScene("truth-stick-slip");
  for (Material& material : scene.joint.materials) material.friction = wish.friction;
  scene.joint.parts = {plainBox("plate", 1, Vec3(-0.1, -0.01, -0.06), Vec3(0.2, 0, 0.06)),
                       plainBox("block", 2, Vec3(-0.02, 0, -0.02), Vec3(0.02, 0.02, 0.02)),
                       plainBox("hand", 3, Vec3(0.02, 0, -0.02), Vec3(0.03, 0.02, 0.02))};
  Part& block = scene.joint.parts[1];
  block.regions.push_back(regionIn(block, "face", levelAt(0, 0.02)));
  const double mass = 2000 * 0.04 * 0.02 * 0.04;
  scene.joint.couplings.push_back(
      {"spring", "block", "hand", "face", mass * wish.omega * wish.omega / (0.02 * 0.04), 0, ""});
  scene.joint.exclusions = {{"block", "hand", "joined by a spring"}, {"plate", "hand", "moved by hand"}};
  scene.scenario.fixedParts = {"plate", "hand"};
  // The spring pulls along X alone: what moves it stays level.
  scene.scenario.motions = {{"hand", Vec3::Zero(), {{0, Vec3::Zero()}, {2, Vec3(2 * wish.speed, 0, 0)}}}};
  scene.scenario.dt = dt;
  return scene;
}

double stickSlipWay(const StickSlip& wish, double time) {
  const double begins = wish.friction * kSlideGravity / (wish.omega * wish.omega * wish.speed),
               since = time - begins;
  return since <= 0 ? 0 : wish.speed * (since - std::sin(wish.omega * since) / wish.omega);
}

TruthScene clampedBar(int through, double load, double stiffness) {
  TruthScene scene = namedScene("truth-elastica");
  Material& tissue = scene.joint.materials[1];
  constexpr double kYoung = 1e6, kThick = kBarLength / 20;
  tissue.youngsModulus = stiffness * kYoung;
  tissue.poissonRatio = 0;
  tissue.massDamping = tissue.stiffnessDamping = 0;
  const Vec3 low(0, -kThick / 2, -kThick / 2), high(kBarLength, kThick / 2, kThick / 2);
  scene.joint.parts.push_back(plainBox("wall", 1, Vec3(-0.01, -0.01, -0.01), Vec3(0, 0.01, 0.01)));
  Part bar = boxPart("bar", 2, PartKind::Soft, low, high);
  bar.volume =
      std::make_shared<TetMesh>(boxVolume(low, high, 20 * through, through, std::max(1, through / 2)));
  bar.cellSize = kThick / through;
  bar.visual = std::make_shared<TriMesh>(boxSurface(low, high, 20));
  bar.regions.push_back(regionIn(bar, "end", levelAt(0, 0)));
  scene.joint.parts.push_back(bar);
  scene.joint.couplings.push_back({"glue", "bar", "wall", "end", 1e4 * kYoung / kThick, 0, ""});
  scene.joint.exclusions = {{"bar", "wall", "glued"}};
  scene.scenario.fixedParts = {"wall"};
  scene.scenario.gravity_W.setZero();
  scene.scenario.effects.contact = Wish::Off;
  const double bending = kYoung * std::pow(kThick, 4) / 12,
               force = load * bending / (kBarLength * kBarLength);
  scene.scenario.loads.push_back({"bar", Vec3(0, -force, 0), Vec3::Zero(), Vec3(kBarLength, 0, 0)});
  scene.scenario.dt = 0.1;
  return scene;
}

double elasticaDrop(double load) {
  // θ'' = −load cos θ over s in [0, 1], θ(0) = 0, θ'(1) = 0, y' = sin θ; θ'(0) by halving, since θ'(1) grows
  // with it.
  double drop = 0;
  const auto endSlope = [&](double slope) {
    constexpr int kSteps = 4000;
    const double h = 1.0 / kSteps;
    double theta = 0, rate = slope;
    drop = 0;
    for (int i = 0; i < kSteps; ++i) {  // Runge and Kutta's fourth order
      const auto bend = [&](double angle) { return -load * std::cos(angle); };
      const double k1 = rate, l1 = bend(theta), k2 = rate + h / 2 * l1, l2 = bend(theta + h / 2 * k1),
                   k3 = rate + h / 2 * l2, l3 = bend(theta + h / 2 * k2);
      const double k4 = rate + h * l3, l4 = bend(theta + h * k3);
      const double middle = theta + h / 2 * k2, next = theta + h / 6 * (k1 + 2 * k2 + 2 * k3 + k4);
      drop += h / 6 * (std::sin(theta) + 4 * std::sin(middle) + std::sin(next));
      rate += h / 6 * (l1 + 2 * l2 + 2 * l3 + l4);
      theta = next;
    }
    return rate;
  };
  double low = 0, high = 2 * load;
  for (int i = 0; i < 60; ++i) {
    const double middle = 0.5 * (low + high);
    (endSlope(middle) < 0 ? low : high) = middle;
  }
  endSlope(0.5 * (low + high));
  return drop;
}

}  // namespace glenoid::truth
