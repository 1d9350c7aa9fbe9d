// SPDX-License-Identifier: GPL-3.0-or-later
// Hard couplings: springs that are far too stiff, that close a ring, that want a part on the other side of a bone.
#include <gtest/gtest.h>

#include "tests/hard/HardScenes.h"

namespace glenoid::hard {
namespace {

constexpr double kSide = 0.02;  // m

Part cube(const std::string& id, int number, PartKind kind, double x, double y) {
  const Vec3 low(x, y, 0);
  return box(id, number, kind, kind == PartKind::Soft ? "tissue" : "bone", low, low + Vec3::Constant(kSide));
}

Joint jointOf(std::vector<Part> parts) {
  Joint joint;
  scenes::addMaterials(joint);
  joint.materials[1].stiffnessDamping = 5e-3;
  joint.parts = std::move(parts);
  return joint;
}

TEST(HardCouplings, springsOfTenToTheTen) {
  HardCase hard;
  hard.name = "couplings of 1e10 N/m";
  hard.joint = jointOf({cube("root", 1, PartKind::Rigid, 0, 0), cube("flesh", 2, PartKind::Soft, kSide, 0),
                        cube("tip", 3, PartKind::Rigid, 2 * kSide, 0)});
  couple(hard.joint, "flesh", 0, 0, "root", 1e10);
  couple(hard.joint, "flesh", 0, 1, "tip", 1e10);
  hard.scenario.fixedParts = {"root"};
  hard.ending = "gravity acts from the first step";
  expectUnshaken(hard);
}

TEST(HardCouplings, aClosedRing) {
  for (const double stiffness : {1e4, 1e10}) {
    HardCase hard;
    hard.name = stiffness > 1e5 ? "closed ring of 1e10 N/m" : "closed ring of 1e4 N/m";
    hard.joint = jointOf({cube("a", 1, PartKind::Rigid, 0, kSide), cube("b", 2, PartKind::Soft, kSide, kSide),
                          cube("c", 3, PartKind::Rigid, kSide, 0), cube("d", 4, PartKind::Soft, 0, 0)});
    couple(hard.joint, "b", 0, 0, "a", stiffness);
    couple(hard.joint, "b", 1, 0, "c", stiffness);
    couple(hard.joint, "d", 0, 1, "c", stiffness);
    couple(hard.joint, "d", 1, 1, "a", stiffness);
    hard.scenario.fixedParts = {"a"};
    hard.ending = "gravity acts from the first step";
    expectUnshaken(hard, [](const HardResult& result, double) { EXPECT_EQ(result.model->couplingIslandCount, 1); });
  }
}

TEST(HardCouplings, aPartIsPulledThroughABone) {
  for (const PartKind kind : {PartKind::Rigid, PartKind::Soft})
    for (const double stiffness : {2e3, 1e6}) {
      HardCase hard;
      hard.name = std::string(kind == PartKind::Soft ? "soft" : "rigid") + " part pulled through bone, " + (stiffness > 1e5 ? "1e6" : "2e3");
      // At rest the part hangs below the bone on its anchor; it starts 6 cm above, and the bone is between.
      hard.joint = jointOf({box("anchor", 1, PartKind::Rigid, "bone", Vec3(0, -0.06, 0), Vec3(0.02, -0.04, 0.02)),
                            box("bone", 2, PartKind::Rigid, "bone", Vec3(-0.04, -0.01, -0.04), Vec3(0.06, 0, 0.06)),
                            cube("part", 3, kind, 0, -0.04)});
      couple(hard.joint, "part", 1, 0, "anchor", stiffness, 1e-3);
      hard.scenario.fixedParts = {"anchor", "bone"};
      hard.start = [](const Model& model, State& state) {
        const ObjectLayout& layout = model.objects[2].layout;
        for (int i = 0; i < (layout.rigid ? 1 : layout.nodeCount); ++i) state.q[layout.qOffset + 3 * i + 1] += 0.06;
      };
      hard.ending = "the springs pull from the first step";
      expectUnshaken(hard, [](const HardResult& result, double) {
        const ObjectLayout& layout = result.model->objects[2].layout;
        for (int i = 0; i < (layout.rigid ? 1 : layout.nodeCount); ++i)
          EXPECT_GT(result.end.q[layout.qOffset + 3 * i + 1], -1e-3) << "it stays above";
      });
    }
}

TEST(HardCouplings, springsOfNoLengthFromTheFirstStep) {
  HardCase hard;
  hard.name = "zero-length springs at rest";
  hard.joint = scenes::figure4Joint();
  hard.scenario = scenes::figure4Scenario();
  hard.scenario.gravity_W.setZero();
  hard.scenario.holds = {{"right", 2e4, 50, 1e-2}};
  hard.scenario.tools = {finger(Vec3(0, 0.1, 0))};
  hard.ending = "nothing ever happens";
  expectUnshaken(hard, [](const HardResult& result, double) {
    // Not a spring has a length, nor a direction: nothing may move by more than round-off.
    EXPECT_LT((result.end.q - result.model->start.q).norm(), 1e-12);
  });
}

}  // namespace
}  // namespace glenoid::hard
