// SPDX-License-Identifier: GPL-3.0-or-later
// Hard matter: stiffness and mass that differ by decades, tissue that keeps its volume, elements without shape.
#include <gtest/gtest.h>

#include "tests/hard/HardScenes.h"

namespace glenoid::hard {
namespace {

TEST(HardMatter, aKilopascalBesideAGigapascalInOneIsland) {
  HardCase hard;
  hard.name = "1 kPa beside 1 GPa";
  scenes::addMaterials(hard.joint);
  hard.joint.materials.push_back(tissue("limp", 1e3, 0.4, 1000, 5e-3));
  hard.joint.materials.push_back(tissue("stiff", 1e9, 0.4, 1000, 5e-3));
  // They hang from a bone: limp, stiff, limp.
  const auto at = [](double y) { return Vec3(0, y, 0); };
  const Vec3 size(0.02, 0.02, 0.02);
  hard.joint.parts = {box("bone", 1, PartKind::Rigid, "bone", at(0.06), at(0.06) + size),
                      box("upper", 2, PartKind::Soft, "limp", at(0.04), at(0.04) + size),
                      box("middle", 3, PartKind::Soft, "stiff", at(0.02), at(0.02) + size),
                      box("lower", 4, PartKind::Soft, "limp", at(0), size)};
  couple(hard.joint, "upper", 1, 1, "bone", 4e5);
  couple(hard.joint, "middle", 1, 1, "upper", 4e5);
  couple(hard.joint, "lower", 1, 1, "middle", 4e5);
  hard.scenario.fixedParts = {"bone"};
  hard.ending = "gravity acts from the first step; the limp parts sag and settle";
  expectUnshaken(hard, [](const HardResult& result, double) {
    EXPECT_EQ(result.model->couplingIslandCount, 1);
    // The upper limp part carries 0.024 kg on 4 cm²: 490 Pa and its own weight, a third of its length.
    const double sag = -result.end.q[result.model->objects[2].layout.qOffset + 1] + 0.02;
    EXPECT_GT(sag, 0.003);
    EXPECT_LT(sag, 0.02);
    EXPECT_LT(shapeError(*result.model, result.end, 2), 1e-5) << "what is stiff keeps its shape";
  });
}

TEST(HardMatter, aMillionTimesHeavierBlockOnALightOne) {
  for (const PartKind kind : {PartKind::Soft, PartKind::Rigid}) {
    HardCase hard;
    hard.name = std::string("mass ratio 1e6 on ") + (kind == PartKind::Soft ? "soft" : "rigid");
    scenes::addMaterials(hard.joint);
    hard.joint.materials.push_back(tissue("light", 1e9, 0.3, 100, 1e-3));
    hard.joint.materials.push_back(tissue("heavy", 1e9, 0.3, 1.25e7, 1e-3));
    hard.joint.parts = {box("plate", 1, PartKind::Rigid, "bone", Vec3(-0.05, -0.01, -0.05), Vec3(0.05, 0, 0.05)),
                        box("light", 2, kind, "light", Vec3(-0.01, 0.0005, -0.01), Vec3(0.01, 0.0205, 0.01)),
                        box("heavy", 3, PartKind::Rigid, "heavy", Vec3(-0.02, 0.021, -0.02), Vec3(0.02, 0.061, 0.02))};
    hard.scenario.fixedParts = {"plate"};
    // Without friction eight kilonewtons between two faces would shoot the light block out sideways, which is right: so
    // it is glued to the plate, and the heavy block is guided. (With friction in place of glue the light block is squeezed
    // out all the same: friction of this mass ratio is a limit, see contact/README.)
    couple(hard.joint, "light", 1, 0, "plate", 1e8);
    hard.scenario.holds = {{"heavy", 1e4, 1e6, 1e-2}};
    hard.ending = "the heavy block has landed after the first hundredth of a second";
    expectUnshaken(hard, [](const HardResult& result, double) {
      EXPECT_NEAR(result.model->objects[2].mass / result.model->objects[1].mass, 1e6, 1);
      EXPECT_GT(result.end.q[result.model->objects[2].layout.qOffset + 1], 0.035) << "the heavy block lies on the light one";
    });
  }
}

TEST(HardMatter, tissueThatHardlyChangesItsVolume) {
  HardCase hard = fingerOverBlock("poisson ratio 0.4999");
  hard.joint.materials[1].poissonRatio = 0.4999;
  hard.loadEnds = 0.7;
  hard.ending = "the finger has pressed for half a second and is gone";
  hard.hands = [](const Model& model, double t) {
    const double y = t < 0.3 ? 0.06 - 0.03 * t / 0.3 : (t < 0.5 ? 0.03 : std::min(0.06, 0.03 + 0.03 * (t - 0.5) / 0.2));
    return Inputs{{handAt(model.scenario.tools[0], Vec3(0, y, 0))}};
  };
  expectUnshaken(hard, [](const HardResult& result, double) {
    EXPECT_LT(shapeError(*result.model, result.end, 1), 1e-3) << "what is left is its weight";
  });
}

TEST(HardMatter, sliversOfAspectTenThousand) {
  // The middle plane of the block's cells is pushed against one side (flat elements), then also a second one
  // (needles): 2 µm beside 2 cm.
  for (const int planes : {1, 2}) {
    HardCase hard = fingerOverBlock(planes == 1 ? "flat slivers of 1e4" : "needles of 1e4");
    Part& block = hard.joint.parts[1];
    auto volume = std::make_shared<TetMesh>(*block.volume);
    for (Vec3& node : volume->nodes) {
      if (std::abs(node.y() - 0.0205) < 1e-9) node.y() = 0.0005 + 2e-6;
      if (planes > 1 && std::abs(node.x()) < 1e-9) node.x() = -0.02 + 2e-6;
    }
    block.volume = volume;
    hard.loadEnds = 0.7;
    hard.ending = "the finger has pressed and is gone";
    hard.hands = [](const Model& model, double t) {
      const double y = t < 0.3 ? 0.06 - 0.025 * t / 0.3 : (t < 0.5 ? 0.035 : std::min(0.06, 0.035 + 0.025 * (t - 0.5) / 0.2));
      return Inputs{{handAt(model.scenario.tools[0], Vec3(0.001, y, 0.002))}};
    };
    expectUnshaken(hard);
  }
}

}  // namespace
}  // namespace glenoid::hard
