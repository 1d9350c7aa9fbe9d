// SPDX-License-Identifier: GPL-3.0-or-later
// The published splitting where contacts press: D by node, judged by the direct solve. And what backward Euler damps.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "simcore/step/Stepper.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

TEST(Paper, aBlockThatPressesIsSolvedByNodesAndAsTheDirectSolveDoes) {
  const Joint joint = scenes::blockOnPlateJoint();
  Scenario scenario = scenes::blockOnPlateScenario();
  scenario.dt = 1e-4;  // s: mass outweighs Δt² K, so that λmax(D⁻¹A) < 2 by node
  scenario.effects.friction = Wish::Off;
  const auto model = compileModel(joint, scenario).value();
  StepperOptions options;
  Stepper direct(model, options);
  options.profile = Profile::Paper;
  Stepper paper(model, options);
  State state = model->start;
  int pressing = 0;
  for (int step = 0; step < 600; ++step) {
    State published = state;
    const StepReport report = paper.step({}, published);
    const double speed = state.v.norm() + scenario.dt * 9.81 * std::sqrt(static_cast<double>(state.v.size()) / 3);
    const StepReport exact = direct.step({}, state);
    if (exact.active == 0) continue;
    ++pressing;
    ASSERT_EQ(report.paper.d, "node") << "step " << step << ", lambda " << report.paper.lambdaMax;
    EXPECT_LT(report.paper.lambdaMax, 2);
    EXPECT_FALSE(report.paper.diverged);
    // The splitting ends at a relative change of 1e-4 an iteration, which leaves some tens of that.
    EXPECT_LT((published.v - state.v).norm(), 5e-3 * std::max(speed, state.v.norm())) << "step " << step;
  }
  EXPECT_GT(pressing, 50);
}

TEST(Paper, asPublishedByDefaultAndEachAdditionByItsName) {
  PaperSettings settings;
  EXPECT_EQ(paperDepartures(settings), (std::vector<std::string>{"explicit-b", "geometric-left-out", "springs-in-regions"}));
  EXPECT_EQ(paperDepartures(settings, false), (std::vector<std::string>{"explicit-b", "geometric-left-out"})) << "all hold at nodes, as published";
  for (const char* word : {"tension", "recovery-cap", "parts", "search-again", "stretch-law"}) {
    ASSERT_NE(paperSetting(settings, word), nullptr) << word;
    EXPECT_FALSE(*paperSetting(settings, word)) << word;
    *paperSetting(settings, word) = true;
    EXPECT_EQ(paperDepartures(settings).front(), word);
    *paperSetting(settings, word) = false;
  }
  EXPECT_EQ(paperSetting(settings, "magic"), nullptr);
}

/// Rate at which a tool on its hand's undamped spring loses amplitude, 1/s, counted over whole steps.
double decayOf(double hertz, double dt) {
  Scenario scenario = scenes::blockOnPlateScenario();
  scenario.tools.resize(1);
  Tool& tool = scenario.tools[0];
  const double omega = 2 * std::numbers::pi * hertz;
  tool.stiffness = tool.mass * omega * omega;
  tool.angularStiffness = 1;
  tool.dampingRatio = 0;
  tool.forceMax = 1e9;
  tool.home.p_WB = Vec3(0, 1, 0);  // m, far from everything
  scenario.dt = dt;
  scenario.effects.contact = Wish::Off;
  const auto model = compileModel(scenes::blockOnPlateJoint(), scenario).value();
  int object = 0;
  while (!model->objects[object].tool) ++object;
  const ObjectLayout& layout = model->objects[object].layout;
  Stepper stepper(model, {});
  State state = model->start;
  // Along the shaft, so that the pull at the tip goes through the centre and turns nothing.
  const Vec3 along = tool.home.q_WB * Vec3::UnitZ();
  state.q.segment<3>(layout.qOffset) += 1e-3 * along;
  const auto energy = [&] {
    const double x = (state.q - model->start.q).segment<3>(layout.qOffset).dot(along), v = state.v.segment<3>(layout.vOffset).dot(along);
    return x * x + v * v / (omega * omega);
  };
  const double before = energy();
  const int steps = 6;  // few, so that what is left stands far above round-off: at 50 Hz and 20 ms a step leaves a sixth
  for (int i = 0; i < steps; ++i) stepper.step({}, state);
  return -0.5 * std::log(energy() / before) / (steps * dt);
}

TEST(NumericalDamping, isWhatTheReadmeSays) {
  // x and v/ω of an undamped oscillator shrink by √(1 + ω²Δt²) in each step of backward Euler, whatever their phase.
  for (const double hertz : {1.0, 10.0, 25.0, 50.0})
    for (const double dt : {1e-3, 5e-3, 20e-3}) {
      const double w = 2 * std::numbers::pi * hertz, exact = std::log1p(w * w * dt * dt) / (2 * dt);
      EXPECT_NEAR(decayOf(hertz, dt), exact, 1e-6 * exact) << hertz << " Hz, " << dt << " s";  // round-off of 1e-3 m beside 1 m
      if (w * dt < 0.1) EXPECT_NEAR(exact, w * w * dt / 2, 0.01 * exact);  // the rule of thumb
    }
}

}  // namespace
}  // namespace glenoid
