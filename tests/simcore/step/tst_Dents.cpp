// SPDX-License-Identifier: GPL-3.0-or-later
// A soft part that gives under a tip beyond its own elements, against Hertz' law and what its table says.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "simcore/scene/JointFile.h"
#include "simcore/step/Stepper.h"
#include "tests/scenes/LadderScenes.h"

namespace glenoid {
namespace {

constexpr double kMore = 0.2e-3;                          // m/N: what the block gives beyond a half-space
constexpr double kModulus = 50e3 / (1 - 0.4 * 0.4);       // Pa, of scenes::addMaterials
constexpr double kRadius = 3e-3;                          // m, of the ball

/// A table that says the same everywhere: a half-space, and kMore under any patch.
DentTable evenTable(double depthMost) {
  DentTable table;
  table.radii = {1e-3, 2e-3, 4e-3};
  DentSample sample;
  sample.modulus = kModulus;
  sample.depthMost = depthMost;
  for (std::size_t k = 0; k < table.radii.size(); ++k)
    sample.compliance[k] = 16 / (3 * std::numbers::pi * std::numbers::pi * kModulus * table.radii[k]) + kMore;
  table.samples = {sample, sample};
  table.samples[1].at_W = Vec3(0.01, 0, 0);
  return table;
}

/// Hertz' ball on that half-space, and what is given beyond.
double sunk(double force) {
  const double a = std::cbrt(0.75 * force * kRadius / kModulus);
  return a * a / kRadius + kMore * force;
}

/// A soft block glued to a fixed plate, with a ball over the middle of its top whose hand wants it `push` below. Nothing falls.
scenes::LadderScene ballOverBlock(double depthMost, double push = 2.5e-3) {
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
  ball.radius = kRadius;
  ball.stiffness = 2000;
  ball.home.q_WB = Quat::FromTwoVectors(Vec3::UnitZ(), Vec3::UnitY());
  ball.home.p_WB = Vec3(1e-3, -push, 2e-3);
  scene.scenario.tools = {ball};
  if (depthMost > 0) {
    DentTable table = evenTable(depthMost);
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
  /// Height of the ball's lowest point, m.
  double tip() const {
    const Tool& tool = model->scenario.tools[0];
    const int offset = model->objects.back().layout.qOffset;
    const Vec3 tip_B = tool.home.q_WB.conjugate() * (tool.home.p_WB - poseAt(model->start.q, offset).p_WB);
    return (poseAt(state.q, offset) * tip_B).y();
  }
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

TEST(Dents, aBallSinksAsTheTissueSaysWhateverItsElementsGive) {
  for (const auto& [profile, tolerance] : {std::pair{Profile::Direct, 1e-4}, {Profile::Reference, 1e-4}, {Profile::Paper, 1e-2}}) {
    StepperOptions options;
    options.profile = profile;
    const Rest rest = pressed(ballOverBlock(8e-3), options);
    ASSERT_TRUE(rest.model->effectOn("dent"));
    ASSERT_EQ(rest.report.dents.size(), 1u);
    ASSERT_GT(rest.force(), 0.2);
    EXPECT_NEAR(-rest.tip(), sunk(rest.force()), 0.03 * sunk(rest.force())) << "of the coarse elements and of the dent together";
    const DentView& dent = rest.report.dents[0];
    EXPECT_GT(dent.depth, 0.2 * sunk(rest.force())) << "the elements alone are too stiff";
    EXPECT_NEAR(rest.deepest(), dent.depth, tolerance * dent.depth);
    EXPECT_GT(dent.normal_W.y(), 0.999);
    EXPECT_EQ(rest.model->objects[dent.object].id, "block");
    EXPECT_EQ(rest.model->objects[dent.tool].id, "ball");
  }
}

TEST(Dents, theTipStopsAtTheBottom) {
  const Rest soft = pressed(ballOverBlock(0.15e-3)), hard = pressed(ballOverBlock(0));
  EXPECT_NEAR(soft.deepest(), 0.15e-3, 1e-7);
  EXPECT_NEAR(hard.deepest(), 0, 1e-7);
  EXPECT_GT(soft.force(), 1.5 * pressed(ballOverBlock(8e-3)).force()) << "there it is as stiff as its elements";
  ASSERT_EQ(soft.report.dents.size(), 1u);
  EXPECT_NEAR(soft.report.dents[0].depth, 0.15e-3, 1e-7);
}

TEST(Dents, whatIsOffOrNoLongerTrueLeavesNoTrace) {
  const Rest without = pressed(ballOverBlock(0));
  scenes::LadderScene off = ballOverBlock(2e-3);
  off.scenario.effects.dent = Wish::Off;
  const Rest asked = pressed(off);
  EXPECT_FALSE(asked.model->effectOn("dent"));
  EXPECT_EQ(stateHash(asked.state), stateHash(without.state));
  EXPECT_TRUE(asked.report.dents.empty());

  scenes::LadderScene stale = ballOverBlock(2e-3);
  for (Material& material : stale.joint.materials) material.youngsModulus *= 1.01;
  const auto model = compileModel(stale.joint, stale.scenario).value();
  EXPECT_FALSE(model->effectOn("dent")) << "the table is of another tissue";
}

TEST(Dents, anyNumberOfThreadsGivesTheSameBits) {
  StepperOptions two;
  two.threads = 2;
  EXPECT_EQ(stateHash(pressed(ballOverBlock(2e-3)).state), stateHash(pressed(ballOverBlock(2e-3), two).state));
}

TEST(Dents, aHandThatStrikesComesToRest) {
  scenes::LadderScene scene = ballOverBlock(1e-3);
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
