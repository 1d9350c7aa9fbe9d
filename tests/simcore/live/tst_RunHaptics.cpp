// SPDX-License-Identifier: GPL-3.0-or-later
// A paced run that is felt: haptic threads beside it, under the thread sanitizer too.
#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

#include "simcore/live/Run.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

DeviceProfile strong() {
  DeviceProfile device = unknownDevice();
  device.id = "strong";
  device.damping = 2;
  device.forceMax = 20;
  return device;
}

std::shared_ptr<const Model> blockModel(const Effects& effects = {}) {
  Scenario scenario = scenes::blockOnPlateScenario();
  scenario.effects = effects;
  const auto model = compileModel(scenes::blockOnPlateJoint(), scenario);
  EXPECT_TRUE(model) << (model ? "" : toLogLine(model.error()));
  return *model;
}

/// The finger goes onto the block within 0.3 s and leans on it.
Recording leaning(const Scenario& scenario) {
  Pose down = scenario.tools[0].home;
  down.p_WB.y() = 0.037;
  Recording input;
  input.tracks = {{scenario.tools[0].id, {{0, scenario.tools[0].home}, {0.3, down}}}};
  return input;
}

RunOptions felt(const Recording& input, double seconds) {
  RunOptions options;
  options.seconds = seconds;
  options.input = &input;
  options.checks = false;
  options.realtime = true;
  options.haptic = HapticWishes{strong(), 0};
  return options;
}

TEST(RunHaptics, aRunThatIsFeltReportsItAndHasTheBitsOfOneThatIsNot) {
  const auto model = blockModel();
  const Recording input = leaning(model->scenario);
  RunOptions options = felt(input, 0.8);
  const auto with = runScenario(model, options);
  options.realtime = false;
  const auto without = runScenario(model, options);
  ASSERT_TRUE(with && without);
  EXPECT_EQ(with->report.stateHash, without->report.stateHash);
  EXPECT_FALSE(without->report.haptic);
  ASSERT_TRUE(with->report.haptic);
  const HapticReport& haptic = *with->report.haptic;
  EXPECT_EQ(haptic.device, "strong");
  EXPECT_GT(haptic.ticks, 100);
  EXPECT_NEAR(static_cast<double>(haptic.ticks + haptic.missed), 1000 * with->report.pace->wallSeconds, 60);
  EXPECT_GT(haptic.forceMaxN, 0.1);
  EXPECT_FALSE(haptic.forceErrorRms) << "was not asked for";
  ASSERT_EQ(haptic.tools.size(), 1u);
  EXPECT_EQ(haptic.tools[0].tool, "finger");
  EXPECT_EQ(haptic.tools[0].stiffness, 800);
  EXPECT_FALSE(haptic.tools[0].saturated);
  for (const EffectReport& effect : with->report.effects)
    if (effect.name == "haptics") {
      EXPECT_EQ(effect.state, "on");
      EXPECT_TRUE(effect.ms);
    }
}

TEST(RunHaptics, itsForcesAreThoseOfTheExactStepAtItsRate) {
  const auto model = blockModel();
  const Recording input = leaning(model->scenario);
  RunOptions options = felt(input, 0.8);
  options.haptic->compareSeconds = 0.8;
  const auto run = runScenario(model, options);
  ASSERT_TRUE(run && run->report.haptic && run->report.haptic->forceErrorRms);
  const HapticToolReport& tool = run->report.haptic->tools[0];
  EXPECT_GT(*tool.forceRms, 0.1);
  // A machine that many share may be late by tens of milliseconds, in which a hand has gone on: the bench judges the figure.
  EXPECT_LT(*tool.forceErrorRms, 0.5 * *tool.forceRms);
}

TEST(RunHaptics, whereThereIsNothingToFeelTheReportSaysWhy) {
  const auto model = blockModel();
  const Recording input = leaning(model->scenario);
  RunOptions options = felt(input, 0.05);
  options.stepper.profile = Profile::Paper;
  const auto paper = runScenario(model, options);
  ASSERT_TRUE(paper);
  EXPECT_FALSE(paper->report.haptic);
  EXPECT_EQ(paper->report.hapticReason, "profile-paper");

  options.stepper.profile = Profile::Direct;
  Effects off;
  off.haptics = Wish::Off;
  const auto asked = runScenario(blockModel(off), options);
  ASSERT_TRUE(asked);
  EXPECT_EQ(asked->report.hapticReason, "asked-off");
  Effects noContact;
  noContact.contact = Wish::Off;
  const auto open = runScenario(blockModel(noContact), options);
  ASSERT_TRUE(open);
  EXPECT_EQ(open->report.hapticReason, "no-contact");
  const nlohmann::json json = nlohmann::json::parse(toJson(open->report));
  EXPECT_TRUE(json["haptic"].is_null());
  EXPECT_EQ(json["hapticReason"], "no-contact");
}

}  // namespace
}  // namespace glenoid
