// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/truth/TruthContacts.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simcore/mesh/TetTools.h"

namespace glenoid::truth {

namespace {

/// Ball with its lowest point at the origin; rings crowd toward it, since only its bottom touches anything.
TriMesh ballSurface(double radius, double finest) {
  TriMesh mesh;
  constexpr int kAround = 24;
  mesh.vertices.push_back(Vec3::Zero());
  std::vector<double> angles;
  for (double angle = finest / radius; angle < std::numbers::pi - 0.15;
       angle += std::clamp(0.3 * angle, finest / radius, 0.3))
    angles.push_back(angle);
  for (const double angle : angles)
    for (int s = 0; s < kAround; ++s) {
      const double around = 2 * std::numbers::pi * s / kAround;
      mesh.vertices.push_back(radius * Vec3(std::sin(angle) * std::cos(around), 1 - std::cos(angle),
                                            std::sin(angle) * std::sin(around)));
    }
  mesh.vertices.push_back(Vec3(0, 2 * radius, 0));
  const int rings = static_cast<int>(angles.size()), top = static_cast<int>(mesh.vertices.size()) - 1;
  const auto at = [&](int ring, int s) { return 1 + ring * kAround + s % kAround; };
  for (int s = 0; s < kAround; ++s) {
    mesh.triangles.push_back({0, at(0, s), at(0, s + 1)});
    for (int r = 0; r + 1 < rings; ++r) {
      mesh.triangles.push_back({at(r, s), at(r + 1, s), at(r + 1, s + 1)});
      mesh.triangles.push_back({at(r, s), at(r + 1, s + 1), at(r, s + 1)});
    }
    mesh.triangles.push_back({top, at(rings - 1, s + 1), at(rings - 1, s)});
  }
  if (enclosedVolume(mesh) < 0)
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

}  // namespace

TruthScene ballOnBlock(double radius, double mass, double youngsModulus, double cell, double growth,
                       double reach) {
  TruthScene scene = namedScene("ball");
  std::vector<double> half{0};
  for (double step = cell; half.back() < reach; step *= half.size() > 2 ? growth : 1)
    half.push_back(half.back() + step);
  std::vector<double> across, down;
  for (auto it = half.rbegin(); it != half.rend(); ++it) across.push_back(-*it);
  down = across;
  across.insert(across.end(), half.begin() + 1, half.end());

  auto ball = std::make_shared<TriMesh>(ballSurface(radius, 0.5 * cell));
  Material& bone = scene.joint.materials[0];
  bone.density = mass / enclosedVolume(*ball);
  Material& tissue = scene.joint.materials[1];
  tissue.youngsModulus = youngsModulus;
  tissue.poissonRatio = 0.3;
  tissue.density = 1e-2;
  Part ballPart = boxPart("ball", 1, PartKind::Rigid, Vec3::Zero(), Vec3::Ones());
  ballPart.visual = ballPart.collision = ball;
  scene.joint.parts.push_back(ballPart);
  const Vec3 low(across.front(), down.front(), across.front()), high(across.back(), 0, across.back());
  Part block = boxPart("block", 2, PartKind::Soft, low, high);
  block.visual = block.collision = std::make_shared<TriMesh>(gradedSurface(across, down, across));
  block.volume = std::make_shared<TetMesh>(gradedVolume(across, down, across));
  block.regions.push_back(regionIn(block, "bottom", levelAt(1, low.y())));
  scene.joint.parts.push_back(block);
  scene.joint.parts.push_back(
      boxPart("plate", 3, PartKind::Rigid, low - Vec3(0, 0.01, 0), Vec3(high.x(), low.y(), high.z())));
  scene.joint.couplings.push_back({"glue", "block", "plate", "bottom", 1e9, 0});
  scene.scenario.fixedParts = {"plate"};
  return scene;
}

double layerDepth(double contactOverThickness) {
  constexpr double nu = 0.3, pi = std::numbers::pi;
  const double alpha = -(1.2876 - 1.4678 * nu + 1.3442 * nu * nu) / (1 - nu),
               beta = (0.6387 - 1.0277 * nu + 1.5164 * nu * nu) / (1 - nu);
  const auto stiffer = [&](double chi) {
    return 1 - 2 * alpha / pi * chi + 4 * alpha * alpha / (pi * pi) * chi * chi -
           8 / std::pow(pi, 3) * (std::pow(alpha, 3) + 4 * pi * pi / 15 * beta) * std::pow(chi, 3) +
           16 * alpha / std::pow(pi, 4) * (std::pow(alpha, 3) + 3 * pi * pi / 5 * beta) * std::pow(chi, 4);
  };
  double depth = 1;  // χ = √(R d)/h is that of the layer's own depth
  for (int n = 0; n < 50; ++n) depth = std::pow(stiffer(contactOverThickness * std::sqrt(depth)), -2.0 / 3);
  return depth;
}

TruthScene contactPatch(int below, int above, double stiffness) {
  TruthScene scene = namedScene("truth-contact-patch");
  Material& tissue = scene.joint.materials[1];
  tissue.youngsModulus = stiffness * kPatchYoung;
  tissue.poissonRatio = 0.3;
  tissue.friction = 0;
  tissue.massDamping = tissue.stiffnessDamping = 0;
  scene.joint.materials.erase(scene.joint.materials.begin());
  const auto evenly = [](double from, double to, int count) {
    std::vector<double> at;
    for (int i = 0; i <= count; ++i) at.push_back(from + (to - from) * i / count);
    return at;
  };
  const auto part = [&](const char* id, int number, double side, double bottom, double top, int along,
                        int up) {
    const std::vector<double> across = evenly(0, side, along), height = evenly(bottom, top, up);
    Part soft = boxPart(id, number, PartKind::Soft, Vec3(0, bottom, 0), Vec3(side, top, side));
    soft.visual = soft.collision = std::make_shared<const TriMesh>(gradedSurface(across, height, across));
    soft.volume = std::make_shared<const TetMesh>(gradedVolume(across, height, across));
    soft.cellSize = side / along;
    return soft;
  };
  Part slab = part("slab", 1, 0.08, -0.02, 0, below, std::max(1, below / 4)),
       block = part("block", 2, 0.04, kPatchGap, 0.02 + kPatchGap, above, std::max(1, above / 2));
  slab.regions = {regionIn(slab, "bottom", levelAt(1, -0.02)), regionIn(slab, "top", levelAt(1, 0)),
                  regionIn(slab, "left", levelAt(0, 0)), regionIn(slab, "back", levelAt(2, 0))};
  block.regions = {regionIn(block, "top", levelAt(1, 0.02 + kPatchGap)),
                   regionIn(block, "left", levelAt(0, 0)), regionIn(block, "back", levelAt(2, 0))};
  // What the slab shows beside the block.
  std::vector<int> open;
  for (const int t : trianglesOf(slab.regions[1])) {
    const auto& c = slab.visual->triangles[static_cast<std::size_t>(t)];
    const Vec3 middle =
        (slab.visual->vertices[c[0]] + slab.visual->vertices[c[1]] + slab.visual->vertices[c[2]]) / 3;
    if (std::max(middle.x(), middle.z()) > 0.04) open.push_back(t);
  }
  slab.regions[1] = {"open", "open", "other", SurfaceKind::Visual, runsOf(open)};
  scene.joint.parts = {slab, block};
  Scenario& s = scene.scenario;
  s.gravity_W.setZero();
  s.effects.friction = s.effects.selfContact = Wish::Off;
  const double stiff = 1e4 * kPatchYoung / 0.02;
  s.supports = {{"slab", "bottom", Axes{false, true, false}, stiff, 0},
                {"slab", "left", Axes{true, false, false}, stiff, 0},
                {"slab", "back", Axes{false, false, true}, stiff, 0},
                {"block", "left", Axes{true, false, false}, stiff, 0},
                {"block", "back", Axes{false, false, true}, stiff, 0}};
  s.pressures = {{"block", "top", kPatchPressure}, {"slab", "open", kPatchPressure}};
  s.dt = 0.05;
  s.contactDistance = 5e-4;
  return scene;
}

TruthScene capstan(int around, double friction) {
  TruthScene scene = namedScene("truth-capstan");
  constexpr double kRadius = 0.02, kThick = 0.001, kHalfWidth = 0.004, kLeg = 0.02, pi = std::numbers::pi;
  for (Material& material : scene.joint.materials) material.friction = friction;
  Material& tissue = scene.joint.materials[1];
  tissue.youngsModulus = 2e6;
  tissue.poissonRatio = 0;
  tissue.density = 200;
  tissue.massDamping = 20;
  tissue.stiffnessDamping = 1e-3;
  // A prism as wide as it need be, whose corners the band's vertices meet.
  auto drum = std::make_shared<TriMesh>();
  const int corners = 2 * around;
  for (const double z : {-2 * kHalfWidth, 2 * kHalfWidth})
    for (int i = 0; i < corners; ++i)
      drum->vertices.push_back(
          {kRadius * std::cos(2 * pi * i / corners), kRadius * std::sin(2 * pi * i / corners), z});
  for (const double z : {-2 * kHalfWidth, 2 * kHalfWidth}) drum->vertices.push_back({0, 0, z});
  for (int i = 0; i < corners; ++i) {
    const int j = (i + 1) % corners;
    drum->triangles.insert(drum->triangles.end(), {{i, j, corners + j},
                                                   {i, corners + j, corners + i},
                                                   {2 * corners, j, i},
                                                   {2 * corners + 1, corners + i, corners + j}});
  }
  Part roller = boxPart("drum", 1, PartKind::Rigid, Vec3::Zero(), Vec3::Ones());
  roller.visual = roller.collision = drum;
  // The band: down on the left, over the top, down on the right.
  const int leg = std::max(2, static_cast<int>(std::lround(kLeg / (pi * kRadius / around))));
  const auto place = [&](double along, double out, double z) -> Vec3 {
    const double inner = kRadius / std::cos(pi / corners) + 1e-5 + out;
    if (along < leg) return {-inner, -kLeg * (leg - along) / leg, z};
    if (along > leg + around) return {inner, -kLeg * (along - leg - around) / leg, z};
    const double angle = pi * (along - leg) / around;
    return {-inner * std::cos(angle), inner * std::sin(angle), z};
  };
  const int along = around + 2 * leg;
  Part band = boxPart("band", 2, PartKind::Soft, Vec3::Zero(), Vec3::Ones());
  TetMesh volume = boxVolume(Vec3::Zero(), Vec3(along, 1, 2), along, 1, 2);
  TriMesh surface = gradedSurface(
      [&] {
        std::vector<double> x;
        for (int i = 0; i <= along; ++i) x.push_back(i);
        return x;
      }(),
      {0, 1}, {0, 1, 2});
  const auto bent = [&](const Vec3& x) { return place(x.x(), kThick * x.y(), kHalfWidth * (x.z() - 1)); };
  std::vector<int> held;
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& c = surface.triangles[t];
    if ((surface.vertices[c[0]].x() + surface.vertices[c[1]].x() + surface.vertices[c[2]].x()) / 3 < 1e-6)
      held.push_back(static_cast<int>(t));
  }
  for (Vec3& x : volume.nodes) x = bent(x);
  for (Vec3& x : surface.vertices) x = bent(x);
  if (enclosedVolume(surface) < 0)
    for (auto& t : surface.triangles) std::swap(t[1], t[2]);
  for (std::size_t t = 0; t < volume.tets.size(); ++t)
    if (tetVolume(volume, static_cast<int>(t)) < 0) std::swap(volume.tets[t][0], volume.tets[t][1]);
  band.volume = std::make_shared<const TetMesh>(std::move(volume));
  band.visual = band.collision = std::make_shared<const TriMesh>(std::move(surface));
  band.cellSize = pi * kRadius / around;
  band.regions = {{"held", "held", "other", SurfaceKind::Visual, runsOf(held)}};
  scene.joint.parts = {roller, band};
  Scenario& s = scene.scenario;
  s.gravity_W.setZero();
  s.fixedParts = {"drum"};
  s.effects.selfContact = Wish::Off;
  s.supports = {{"band", "held", Axes{}, kCapstanSpring / (kThick * 2 * kHalfWidth), 0}};
  s.loads = {{"band", Vec3(0, -kCapstanPull, 0), Vec3::Zero(), place(along - 0.25, 0.5 * kThick, 0)}};
  s.loadRise = kCapstanRise;
  s.contactDistance = 3e-4;
  s.dt = 0.002;
  return scene;
}

}  // namespace glenoid::truth
