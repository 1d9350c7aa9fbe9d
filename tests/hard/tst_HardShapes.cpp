// SPDX-License-Identifier: GPL-3.0-or-later
// Hard shapes: a free part starts far from any shape it could have had, and finds back.
#include <gtest/gtest.h>

#include <random>

#include "tests/hard/HardScenes.h"

namespace glenoid::hard {
namespace {

constexpr double kSide = 0.02;  // m

/// One soft cube in empty space; `place` moves its nodes.
HardCase looseCube(const std::string& name, const std::function<Vec3(const Vec3&)>& place) {
  HardCase hard;
  hard.name = name;
  scenes::addMaterials(hard.joint);
  hard.joint.materials.push_back(tissue("muscle", 5e4, 0.4, 1000, 1e-3));
  // Frozen rotations leave a cube that finds back from chaos with a spin that nothing gave it, some 20 rad/s; where
  // there is nothing to touch only the fluid stops it.
  hard.joint.materials.back().massDamping = 10;  // 1/s
  hard.joint.parts = {box("cube", 1, PartKind::Soft, "muscle", Vec3::Constant(-kSide / 2), Vec3::Constant(kSide / 2), 3)};
  hard.scenario.gravity_W.setZero();
  hard.start = [place](const Model& model, State& state) {
    const ObjectLayout& layout = model.objects[0].layout;
    for (int node = 0; node < layout.nodeCount; ++node) {
      auto x = state.q.segment<3>(layout.qOffset + 3 * node);
      x = place(x);
    }
  };
  hard.ending = "it is let go in the first step";
  return hard;
}

void expectShapeBack(const HardCase& hard) {
  expectUnshaken(hard, [](const HardResult& result, double) {
    // A thousandth of its side.
    EXPECT_LT(shapeError(*result.model, result.end, 0), 1e-3 * kSide);
  });
}

TEST(HardShapes, everyNodeScattered) {
  for (const unsigned seed : {1u, 2u, 3u}) {
    auto random = std::make_shared<std::mt19937>();
    HardCase hard = looseCube("nodes scattered, seed " + std::to_string(seed), {});
    hard.start = [seed](const Model& model, State& state) {
      std::mt19937 draw(seed);
      for (int i = 0; i < model.objects[0].layout.qSize; ++i)
        state.q[model.objects[0].layout.qOffset + i] = kSide * (draw() / 4294967296.0 - 0.5);
    };
    expectShapeBack(hard);
  }
}

TEST(HardShapes, collapsedToAPlane) {
  expectShapeBack(looseCube("collapsed to a plane", [](const Vec3& x) { return Vec3(x.x(), 0, x.z()); }));
}

TEST(HardShapes, collapsedToAPoint) {
  expectShapeBack(looseCube("collapsed to a point", [](const Vec3&) { return Vec3(0.001, 0.002, 0.003); }));
}

TEST(HardShapes, mirrored) {
  expectShapeBack(looseCube("mirrored", [](const Vec3& x) { return Vec3(-x.x(), x.y(), x.z()); }));
  expectShapeBack(looseCube("turned inside out", [](const Vec3& x) { return Vec3(-x); }));
}

}  // namespace
}  // namespace glenoid::hard
