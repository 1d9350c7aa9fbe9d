// SPDX-License-Identifier: GPL-3.0-or-later
// Hard shapes: a free part starts far from any shape it could have had, and finds back.
#include <gtest/gtest.h>

#include "tests/hard/HardScenes.h"

namespace glenoid::hard {
namespace {

constexpr double kSide = 0.02;  // m

/// One soft cube in empty space, in a shape of the gauntlet.
HardCase looseCube(const std::string& name, Misshape shape, unsigned seed = 1) {
  HardCase hard;
  hard.name = name;
  scenes::addMaterials(hard.joint);
  hard.joint.materials.push_back(tissue("muscle", 5e4, 0.4, 1000, 1e-3));
  // Frozen rotations leave a cube that finds back from chaos with a spin that nothing gave it, some 20 rad/s; where
  // there is nothing to touch only the fluid stops it.
  hard.joint.materials.back().massDamping = 10;  // 1/s
  hard.joint.parts = {box("cube", 1, PartKind::Soft, "muscle", Vec3::Constant(-kSide / 2), Vec3::Constant(kSide / 2), 3)};
  hard.scenario.gravity_W.setZero();
  hard.start = [shape, seed](const Model& model, State& state) { misshape(model, 0, shape, seed, state); };
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
  for (const unsigned seed : {1u, 2u, 3u}) expectShapeBack(looseCube("nodes scattered, seed " + std::to_string(seed), Misshape::Scattered, seed));
}

TEST(HardShapes, collapsedToAPlane) { expectShapeBack(looseCube("collapsed to a plane", Misshape::CollapsedToPlane)); }

TEST(HardShapes, collapsedToAPoint) { expectShapeBack(looseCube("collapsed to a point", Misshape::CollapsedToPoint)); }

TEST(HardShapes, mirrored) {
  expectShapeBack(looseCube("mirrored", Misshape::Mirrored));
  expectShapeBack(looseCube("turned inside out", Misshape::InsideOut));
}

TEST(HardShapes, flattenedToATenth) { expectShapeBack(looseCube("flattened to a tenth", Misshape::Squeezed)); }

}  // namespace
}  // namespace glenoid::hard
