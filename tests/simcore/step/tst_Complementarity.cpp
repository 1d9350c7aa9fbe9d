// SPDX-License-Identifier: GPL-3.0-or-later
// Signorini's condition after every step of whole runs, judged from outside the solver.
#include <gtest/gtest.h>

#include "tests/scenes/BlockScenes.h"
#include "tests/simcore/step/ContactJudge.h"

namespace glenoid {
namespace {

struct Worst {
  double speed = 0;  ///< m/s
  double pull = 0;   ///< N·s
  int active = 0;
  long exhausted = 0;
  int judged = 0, steps = 0;  ///< of all steps those in which the judge saw every contact
};

/// A soft block falls on a plate and a finger presses it down by 15 mm and lets go.
Worst pressABlock(Profile profile, double dt, double young) {
  Joint joint = scenes::blockOnPlateJoint();
  joint.materials[1].youngsModulus = young;
  Scenario scenario = scenes::blockOnPlateScenario();
  scenario.dt = dt;
  const auto model = compileModel(joint, scenario).value();
  Stepper stepper(model, {profile});
  test::ContactJudge judge(*model);
  State state = model->start;
  Inputs hands{{scenario.tools[0].home}};
  Worst worst;
  const int steps = worst.steps = profile == Profile::Reference ? 40 : 300;
  for (int i = 0; i < steps; ++i) {
    hands.hands[0].p_WB.y() = 0.0425 - 0.0175 * std::sin(M_PI * i / steps);
    const State before = state;
    const StepReport& report = stepper.step(hands, state);
    EXPECT_TRUE(report.taken);
    EXPECT_EQ(report.parts, 1);
    const auto verdict = judge.judge(before, state);
    // A step that searched again along the motion that it takes holds contacts that the judge does not look for.
    EXPECT_LE(verdict.rows, report.contacts + report.droppedRows);
    EXPECT_LE(verdict.active, report.active);
    worst.judged += verdict.rows == report.contacts + report.droppedRows;
    worst.speed = std::max({worst.speed, verdict.approach, verdict.both});
    worst.pull = std::max(worst.pull, verdict.pull);
    worst.active = std::max(worst.active, verdict.active);
    worst.exhausted += report.pivotsExhausted;
  }
  return worst;
}

TEST(Complementarity, holdsAfterEveryStepOfAPress) {
  for (const Profile profile : {Profile::Direct, Profile::Reference})
    for (const double dt : {1e-3, 5e-3, 2e-2})
      for (const double young : {5e4, 1e7}) {
        const Worst worst = pressABlock(profile, dt, young);
        EXPECT_EQ(worst.pull, 0);
        EXPECT_EQ(worst.exhausted, 0);
        EXPECT_GT(worst.active, 8);
        EXPECT_GT(worst.judged, worst.steps / 2);
        // Redundant contacts on a flat face share their load by a compliance of 1e-12 of the diagonal; speeds
        // are 0.3 m/s.
        EXPECT_LT(worst.speed, 1e-11) << static_cast<int>(profile) << ", " << dt << " s, " << young << " Pa";
      }
}

}  // namespace
}  // namespace glenoid
