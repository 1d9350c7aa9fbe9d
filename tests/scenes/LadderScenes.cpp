// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/scenes/LadderScenes.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

namespace glenoid::scenes {

namespace {

LadderScene named(const char* id) {
  LadderScene scene;
  scene.joint.id = scene.joint.name = scene.scenario.id = scene.scenario.name = id;
  scene.scenario.elements = wishedElements();
  addMaterials(scene.joint);
  return scene;
}

/// A rigid box with two triangles on each face.
Part plainBox(const std::string& id, int number, const Vec3& low, const Vec3& high) {
  Part part = boxPart(id, number, PartKind::Rigid, low, high);
  part.visual = part.collision = std::make_shared<TriMesh>(boxSurface(low, high, 1));
  return part;
}

Box3 slab(int axis, double at) {
  Vec3 low(-1, -1, -1), high(1, 1, 1);
  low[axis] = at - 1e-6;
  high[axis] = at + 1e-6;
  return {low, high};
}

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

LadderScene twoFallingBoxes() {
  LadderScene scene = named("falling");
  scene.joint.parts.push_back(boxPart("hard", 1, PartKind::Rigid, Vec3(-0.2, 0, 0), Vec3(-0.17, 0.02, 0.05)));
  scene.joint.parts.push_back(boxPart("soft", 2, PartKind::Soft, Vec3(0.2, 0, 0), Vec3(0.23, 0.02, 0.05)));
  return scene;
}

LadderScene twoBoxesOnASpring(double stiffness) {
  LadderScene scene = named("spring");
  scene.joint.parts.push_back(plainBox("first", 1, Vec3(-0.04, -0.01, -0.01), Vec3(0, 0.01, 0.01)));
  scene.joint.parts.push_back(plainBox("second", 2, Vec3(0, -0.01, -0.01), Vec3(0.03, 0.01, 0.01)));
  scene.joint.parts[0].regions.push_back(regionIn(scene.joint.parts[0], "face", slab(0, 0)));
  scene.joint.couplings.push_back({"spring", "first", "second", "face", stiffness / 4e-4, 0});
  scene.scenario.effects.gravity = scene.scenario.effects.contact = Wish::Off;
  return scene;
}

LadderScene hangingBar(int cells, double youngsModulus, double density) {
  LadderScene scene = named("bar");
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
  bar.regions.push_back(regionIn(bar, "top", slab(1, 0)));
  scene.joint.parts.push_back(bar);
  scene.joint.couplings.push_back({"glue", "bar", "plate", "top", 1e10, 0});
  scene.scenario.fixedParts = {"plate"};
  scene.scenario.effects.contact = Wish::Off;
  return scene;
}

LadderScene chainAndLooseBlock() {
  LadderScene scene;
  scene.joint = figure4Joint();
  scene.joint.parts.push_back(
      boxPart("loose", 4, PartKind::Soft, Vec3(-0.01, 0.022, 0.002), Vec3(0.01, 0.04, 0.018)));
  scene.scenario.id = scene.scenario.name = "chain";
  scene.scenario.elements = wishedElements();
  scene.scenario.gravity_W.setZero();
  return scene;
}

LadderScene bandBetweenWalls() {
  LadderScene scene = named("band");
  const Vec3 low(-0.04, -0.0025, -0.005), high(0.04, 0.0025, 0.005);
  scene.joint.parts.push_back(
      boxPart("left", 1, PartKind::Rigid, Vec3(-0.06, -0.01, -0.01), Vec3(-0.04, 0.01, 0.01)));
  Part band = boxPart("band", 2, PartKind::Soft, low, high);
  band.volume = std::make_shared<TetMesh>(boxVolume(low, high, 16, 1, 2));
  band.regions.push_back(regionIn(band, "left-end", slab(0, -0.04)));
  band.regions.push_back(regionIn(band, "right-end", slab(0, 0.04)));
  scene.joint.parts.push_back(band);
  scene.joint.parts.push_back(
      boxPart("right", 3, PartKind::Rigid, Vec3(0.04, -0.01, -0.01), Vec3(0.06, 0.01, 0.01)));
  scene.joint.couplings.push_back({"c12", "band", "left", "left-end", 1e10, 0});
  scene.joint.couplings.push_back({"c23", "band", "right", "right-end", 1e10, 0});
  scene.scenario.fixedParts = {"left", "right"};
  scene.scenario.effects.gravity = scene.scenario.effects.contact = Wish::Off;
  return scene;
}

TetMesh gradedVolume(const std::vector<double>& x, const std::vector<double>& y,
                     const std::vector<double>& z) {
  const int nx = static_cast<int>(x.size()) - 1, ny = static_cast<int>(y.size()) - 1,
            nz = static_cast<int>(z.size()) - 1;
  TetMesh mesh = boxVolume(Vec3::Zero(), Vec3(nx, ny, nz), nx, ny, nz);
  for (Vec3& node : mesh.nodes)
    node = Vec3(x[std::lround(node.x())], y[std::lround(node.y())], z[std::lround(node.z())]);
  return mesh;
}

TriMesh gradedSurface(const std::vector<double>& x, const std::vector<double>& y,
                      const std::vector<double>& z) {
  const TetMesh volume = gradedVolume(x, y, z);
  // Faces of one tetrahedron only; their nodes in the order that looks outwards.
  std::map<std::array<int, 3>, std::array<int, 3>> faces;
  for (const auto& t : volume.tets)
    for (const auto& face : {std::array{t[0], t[2], t[1]}, std::array{t[0], t[1], t[3]},
                             std::array{t[1], t[2], t[3]}, std::array{t[0], t[3], t[2]}}) {
      std::array<int, 3> key = face;
      std::sort(key.begin(), key.end());
      if (!faces.erase(key)) faces[key] = face;
    }
  TriMesh mesh;
  std::map<int, int> vertexOf;
  for (const auto& [key, face] : faces) {
    std::array<int, 3> triangle;
    for (int k = 0; k < 3; ++k) {
      const auto [it, isNew] = vertexOf.try_emplace(face[k], static_cast<int>(mesh.vertices.size()));
      if (isNew) mesh.vertices.push_back(volume.nodes[face[k]]);
      triangle[k] = it->second;
    }
    mesh.triangles.push_back(triangle);
  }
  return mesh;
}

LadderScene ballOnBlock(double radius, double mass, double youngsModulus, double cell, double growth,
                        double reach) {
  LadderScene scene = named("ball");
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
  block.regions.push_back(regionIn(block, "bottom", slab(1, low.y())));
  scene.joint.parts.push_back(block);
  scene.joint.parts.push_back(
      boxPart("plate", 3, PartKind::Rigid, low - Vec3(0, 0.01, 0), Vec3(high.x(), low.y(), high.z())));
  scene.joint.couplings.push_back({"glue", "block", "plate", "bottom", 1e9, 0});
  scene.scenario.fixedParts = {"plate"};
  return scene;
}

}  // namespace glenoid::scenes
