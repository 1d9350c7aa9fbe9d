// SPDX-License-Identifier: GPL-3.0-or-later
// A paced run that is felt: haptic threads beside it, under the thread sanitizer too.
#include <gtest/gtest.h>

#include <cmath>
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
  options.haptic = HapticWishes{strong(), 0, {}};
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
  // A machine that many share may keep the simulation silent, whose forces fade and come back: then it is run again, and where
  // that goes on what is left is that the comparison is there. The figure itself is judged in a time of its own (tst_HapticTrial).
  for (int attempt = 0; attempt < 6; ++attempt) {
    const auto run = runScenario(model, options);
    ASSERT_TRUE(run && run->report.haptic && run->report.haptic->forceErrorRms);
    const HapticToolReport& tool = run->report.haptic->tools[0];
    EXPECT_TRUE(std::isfinite(*tool.forceErrorRms) && std::isfinite(*tool.forceRms));
    if (tool.silentTicks > 0 || tool.lostTicks > 0) continue;
    EXPECT_GT(*tool.forceRms, 0.1);
    EXPECT_LT(*tool.forceErrorRms, 0.5 * *tool.forceRms) << "ticks may be late by milliseconds: the bench judges the figure";
    return;
  }
}

/// Somebody's hand: it leans on the block as the recording does, and is gone after a while.
class Leaner : public HapticDevice {
 public:
  Leaner(const Pose& home, double leavesAfter) : m_home(home), m_leavesAfter(leavesAfter) {}
  bool read(std::int64_t now, ToolInput& input) noexcept override {
    if (m_start == 0) m_start = now;
    const double time = 1e-9 * static_cast<double>(now - m_start);
    input.pose = m_home;
    input.pose.p_WB.y() += (0.037 - m_home.p_WB.y()) * std::min(1.0, time / 0.3);
    input.pose.p_WB.x() += 0.001 * std::sin(9 * time);
    input.stamp = now;
    return time < m_leavesAfter;
  }
  void write(const Vec3& force, const Vec3&) noexcept override {
    most = std::max(most, force.norm());
    last = force.norm();
  }
  double most = 0, last = 0;

 private:
  Pose m_home;
  double m_leavesAfter;
  std::int64_t m_start = 0;
};

TEST(RunHaptics, aDeviceThatHoldsAToolIsFeltRecordedAndReplayedToTheBit) {
  const auto model = blockModel();
  Leaner device(model->scenario.tools[0].home, 1e9);
  RunOptions options = felt({}, 0.8);
  options.input = nullptr;
  options.record = true;
  options.haptic->live = {{&device, "scripted", "finger"}};
  const auto run = runScenario(model, options);
  ASSERT_TRUE(run && run->recording && run->report.haptic);
  const HapticToolReport& tool = run->report.haptic->tools[0];
  EXPECT_GT(device.most, 0.1);
  EXPECT_EQ(device.last, 0) << "it ends without a force";
  ASSERT_TRUE(tool.live);
  EXPECT_TRUE(tool.live->heard);
  EXPECT_EQ(tool.live->device, "scripted");
  ASSERT_EQ(run->recording->tracks.size(), 1u);
  EXPECT_EQ(run->recording->tracks[0].keys.size(), static_cast<std::size_t>(run->report.steps));
  RunOptions again;
  again.steps = run->report.steps;
  again.checks = false;
  again.input = &*run->recording;
  const auto replayed = runScenario(model, again);
  ASSERT_TRUE(replayed);
  EXPECT_EQ(replayed->report.stateHash, run->report.stateHash);
}

TEST(RunHaptics, aDeviceThatLeavesGivesNoForceAndIsReported) {
  const auto model = blockModel();
  Leaner device(model->scenario.tools[0].home, 0.5);
  RunOptions options = felt({}, 0.9);
  options.input = nullptr;
  options.haptic->live = {{&device, "scripted", "finger"}};
  const auto run = runScenario(model, options);
  ASSERT_TRUE(run && run->report.haptic);
  const LiveHandReport live = run->report.haptic->tools[0].live.value();
  EXPECT_GT(live.lostSeconds, 0.1);
  EXPECT_GT(live.lostFrom, 0.2);
  EXPECT_TRUE(run->report.finite);
  const nlohmann::json json = nlohmann::json::parse(toJson(run->report));
  EXPECT_EQ(json["haptic"]["tools"][0]["live"]["device"], "scripted");
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
