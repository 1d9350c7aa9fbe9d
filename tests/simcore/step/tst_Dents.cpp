// SPDX-License-Identifier: GPL-3.0-or-later
// A soft part that gives under a tip beyond its tetrahedra, against what the law of the dent says.
#include <gtest/gtest.h>

#include "simcore/scene/JointFile.h"
#include "simcore/step/Stepper.h"
#include "tests/scenes/LadderScenes.h"

namespace glenoid {
namespace {

constexpr double kCompliance = 0.2e-3;  // m/N

/// A soft block glued to a fixed plate, with a ball over the middle of its top. Nothing falls.
scenes::LadderScene ballOverBlock(double depthMost, double force) {
  scenes::LadderScene scene;
  scene.joint.id = "ball-over-block";
  scenes::addMaterials(scene.joint);
  scene.joint.parts = {scenes::boxPart("plate", 1, PartKind::Rigid, Vec3(-0.02, -0.03, -0.02), Vec3(0.02, -0.02, 0.02)),
                       scenes::boxPart("block", 2, PartKind::Soft, Vec3(-0.02, -0.02, -0.02), Vec3(0.02, 0, 0.02))};
  Part& block = scene.joint.parts[1];
  block.regions.push_back(scenes::regionIn(block, "base", Box3(Vec3(-1, -0.0201, -1), Vec3(1, -0.0199, 1))));
  scene.joint.couplings.push_back({"glue", "block", "plate", "base", 1e9, 1e-3});
  scene.scenario.fixedParts = {"plate"};
  scene.scenario.effects.gravity = Wish::Off;
  Tool ball;
  ball.id = "ball";
  ball.kind = ToolKind::Ball;
  ball.radius = 3e-3;
  ball.stiffness = 2000;
  ball.home.q_WB = Quat::FromTwoVectors(Vec3::UnitZ(), Vec3::UnitY());
  ball.home.p_WB = Vec3(1e-3, 1e-4 - force / ball.stiffness, 2e-3);
  scene.scenario.tools = {ball};
  if (depthMost > 0) {
    DentTable table;
    table.radius = 1.5e-3;
    table.samples = {{Vec3::Zero(), kCompliance, depthMost}, {Vec3(0.01, 0, 0), kCompliance, depthMost}};
    table.basis = dentBasis(scene.joint, block);
    block.dents = std::make_shared<const DentTable>(table);
  }
  return scene;
}

struct Rest {
  std::shared_ptr<const Model> model;
  State state;
  StepReport report;
  double force() const { return report.toolForces[0].y(); }
  double deepest() const {
    double gap = 0;
    for (const ContactView& view : report.contactViews)
      if (view.force > 0) gap = std::min(gap, view.gap);
    return -gap;
  }
};

Rest pressed(const scenes::LadderScene& scene, StepperOptions options = {}) {
  Rest rest;
  rest.model = compileModel(scene.joint, scene.scenario).value();
  rest.state = rest.model->start;
  Stepper stepper(rest.model, options);
  for (int n = 0; n < 600; ++n) rest.report = stepper.step({}, rest.state);
  return rest;
}

TEST(Dents, aTipLiesInTheSurfaceByItsForceTimesTheCompliance) {
  for (const auto& [profile, tolerance] : {std::pair{Profile::Direct, 1e-4}, {Profile::Reference, 1e-4}, {Profile::Paper, 1e-2}}) {
    StepperOptions options;
    options.profile = profile;
    const Rest rest = pressed(ballOverBlock(2e-3, 4), options);
    ASSERT_TRUE(rest.model->effectOn("dent"));
    ASSERT_EQ(rest.report.dents.size(), 1u);
    ASSERT_GT(rest.force(), 1);
    const DentView& dent = rest.report.dents[0];
    EXPECT_NEAR(dent.depth, kCompliance * rest.force(), 0.02 * dent.depth) << "contacts a little apart share a little less";
    EXPECT_NEAR(rest.deepest(), dent.depth, tolerance * dent.depth);
    EXPECT_GT(dent.normal_W.y(), 0.99);
    EXPECT_EQ(rest.model->objects[dent.object].id, "block");
    EXPECT_EQ(rest.model->objects[dent.tool].id, "ball");
  }
}

TEST(Dents, theTipStopsAtTheBottom) {
  const Rest soft = pressed(ballOverBlock(0.15e-3, 4)), hard = pressed(ballOverBlock(0, 4));
  ASSERT_GT(kCompliance * soft.force(), 0.2e-3);
  EXPECT_NEAR(soft.deepest(), 0.15e-3, 1e-7);
  EXPECT_NEAR(hard.deepest(), 0, 1e-7);
  ASSERT_EQ(soft.report.dents.size(), 1u);
  EXPECT_NEAR(soft.report.dents[0].depth, 0.15e-3, 1e-7);
}

TEST(Dents, whatIsOffOrNoLongerTrueLeavesNoTrace) {
  const Rest without = pressed(ballOverBlock(0, 4));
  scenes::LadderScene off = ballOverBlock(2e-3, 4);
  off.scenario.effects.dent = Wish::Off;
  const Rest asked = pressed(off);
  EXPECT_FALSE(asked.model->effectOn("dent"));
  EXPECT_EQ(stateHash(asked.state), stateHash(without.state));
  EXPECT_TRUE(asked.report.dents.empty());

  scenes::LadderScene stale = ballOverBlock(2e-3, 4);
  for (Material& material : stale.joint.materials) material.youngsModulus *= 1.01;
  const auto model = compileModel(stale.joint, stale.scenario).value();
  EXPECT_FALSE(model->effectOn("dent")) << "the table is of another tissue";
}

TEST(Dents, anyNumberOfThreadsGivesTheSameBits) {
  StepperOptions two;
  two.threads = 2;
  EXPECT_EQ(stateHash(pressed(ballOverBlock(2e-3, 4)).state), stateHash(pressed(ballOverBlock(2e-3, 4), two).state));
}

TEST(Dents, aHandThatStrikesComesToRest) {
  scenes::LadderScene scene = ballOverBlock(1e-3, 4);
  scene.scenario.tools[0].home.p_WB.y() = 10e-3;
  const auto model = compileModel(scene.joint, scene.scenario).value();
  State state = model->start;
  Stepper stepper(model, {});
  Inputs inputs;
  inputs.hands = {scene.scenario.tools[0].home};
  double deepest = 0, last = 0;
  for (int n = 0; n < 1200; ++n) {
    // Twenty blows of 12 mm, half a metre a second and more; then still.
    inputs.hands[0].p_WB.y() = n < 800 && n % 40 < 20 ? 10e-3 : -2e-3;
    const StepReport& report = stepper.step(inputs, state);
    ASSERT_TRUE(report.taken);
    for (const ContactView& view : report.contactViews)
      if (view.force > 0) deepest = std::max(deepest, -view.gap);
    last = state.v.norm();
  }
  EXPECT_GT(deepest, 0.2e-3);
  EXPECT_LT(deepest, 1.01e-3) << "the bottom holds";
  EXPECT_LT(last, 1e-6);
}

}  // namespace
}  // namespace glenoid
