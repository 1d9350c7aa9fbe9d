// SPDX-License-Identifier: GPL-3.0-or-later
// Hard motion: spins far beyond what a joint does, and devices that say what no hand could do.
#include <gtest/gtest.h>

#include <cmath>

#include "simcore/step/StepModel.h"
#include "tests/hard/HardScenes.h"

namespace glenoid::hard {
namespace {

HardCase spinning(const std::string& name, PartKind kind, const Vec3& omega) {
  HardCase hard;
  hard.name = name;
  scenes::addMaterials(hard.joint);
  hard.joint.materials[1].stiffnessDamping = 5e-3;
  hard.joint.parts = {box("body", 1, kind, kind == PartKind::Soft ? "tissue" : "bone", Vec3(-0.03, -0.01, -0.02), Vec3(0.03, 0.01, 0.02))};
  hard.scenario.gravity_W.setZero();
  hard.start = [omega](const Model& model, State& state) {
    const ObjectLayout& layout = model.objects[0].layout;
    if (layout.rigid) state.v.segment<3>(layout.vOffset + 3) = omega;
    for (int node = 0; node < layout.nodeCount; ++node)
      state.v.segment<3>(layout.vOffset + 3 * node) = omega.cross(Vec3(state.q.segment<3>(layout.qOffset + 3 * node)));
  };
  hard.comesToRest = false;  // nothing slows it
  hard.loadEnds = 2;
  hard.ending = "it spins for ever";
  return hard;
}

TEST(HardMotion, aBoneSpinsAtAHundredRadiansASecond) {
  // About the axis of middle inertia, nearly: the motion that tumbles.
  const HardCase hard = spinning("rigid spin of 100 rad/s", PartKind::Rigid, Vec3(1, 3, 100).normalized() * 100);
  expectUnshaken(hard, [&](const HardResult& result, double) {
    const ContactObject& body = *result.model->inside->objects[0];
    State start = result.model->start;
    hard.start(*result.model, start);
    // Round-off of ten thousand steps, relative.
    EXPECT_LT((body.momentum(result.end) - body.momentum(start)).norm(), 1e-10 * body.momentum(start).norm());
    EXPECT_NEAR(body.kineticEnergy(result.end), body.kineticEnergy(start), 1e-6 * body.kineticEnergy(start));
  });
}

TEST(HardMotion, tissueSpinsAtAHundredRadiansASecond) {
  expectUnshaken(spinning("soft spin of 100 rad/s", PartKind::Soft, Vec3(1, 3, 100).normalized() * 100));
}

TEST(HardMotion, aSpinningBoneOnAPlate) {
  HardCase hard = spinning("spin of 100 rad/s on a plate", PartKind::Rigid, Vec3(0, 100, 0));
  hard.joint.parts.push_back(box("plate", 2, PartKind::Rigid, "bone", Vec3(-0.06, -0.03, -0.06), Vec3(0.06, -0.011, 0.06)));
  hard.scenario.fixedParts = {"plate"};
  hard.scenario.gravity_W = Vec3(0, -9.81, 0);
  expectUnshaken(hard);
}

TEST(HardMotion, aDeviceThatSaysNonsense) {
  HardCase hard = fingerOverBlock("NaN and 1e30 from a device");
  hard.loadEnds = 1;
  hard.ending = "the device is sane again and back home";
  hard.hands = [](const Model& model, double t) {
    // Home 19.5 mm above the block, a centimetre into it.
    const Touch touch{0, 2, 1, model.scenario.tools[0].home.p_WB, Vec3(0, 0.0405, 0), -Vec3::UnitY(), 0.0105};
    return playHands(model, touch, HandPlay::Wild, 1, t);
  };
  expectUnshaken(hard);
}

}  // namespace
}  // namespace glenoid::hard
