// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/live/HandInput.h"

#include <gtest/gtest.h>

namespace glenoid {
namespace {

constexpr double kDt = 0.005;

Pose at(double x) { return {Vec3(x, 0, 0), Quat::Identity()}; }

Scenario twoTools() {
  Scenario scenario;
  scenario.tools.resize(2);
  scenario.tools[0].id = "probe";
  scenario.tools[0].home = at(1);
  scenario.tools[1].id = "scope";
  scenario.tools[1].home = at(2);
  return scenario;
}

std::shared_ptr<const Recording> straightLine() {
  Recording recording;
  recording.tracks.push_back({"nobody", {{0, at(9)}}});
  recording.tracks.push_back({"probe", {{0, at(1)}, {1, at(1.1)}}});
  return std::make_shared<const Recording>(recording);
}

TEST(HandInput, withoutWishAndRecordingHandsStayAtHome) {
  HandInput input;
  input.restart(twoTools(), nullptr);
  const auto& hands = input.advance({}, kDt, kDt);
  ASSERT_EQ(hands.size(), 2u);
  EXPECT_EQ(hands[0].p_WB.x(), 1);
  EXPECT_EQ(hands[1].p_WB.x(), 2);
}

TEST(HandInput, aToolNeverHeldFollowsTheRecordingExactly) {
  HandInput input;
  const auto recording = straightLine();
  input.restart(twoTools(), recording);
  for (int i = 1; i <= 100; ++i) {
    const double time = i * kDt;
    EXPECT_EQ(input.advance({}, time, kDt)[0].p_WB, handAt(recording->tracks[1], time).p_WB);
  }
  EXPECT_EQ(input.hands()[1].p_WB.x(), 2) << "no track: stays";
}

TEST(HandInput, aHeldToolComesAtABoundedSpeedAndArrives) {
  HandInput input;
  input.restart(twoTools(), straightLine());
  const std::vector<HandWish> wish{{true, at(3)}};
  double last = 1;
  int steps = 0;
  while (last != 3 && steps < 1000) {
    const double x = input.advance(wish, ++steps * kDt, kDt)[0].p_WB.x();
    ASSERT_LE(x - last, HandInput::kHeldSpeed * kDt * (1 + 1e-9));
    last = x;
  }
  EXPECT_EQ(last, 3) << "exactly there, not nearly";
  EXPECT_NEAR(steps * kDt, 2 / HandInput::kHeldSpeed, 2 * kDt);
}

TEST(HandInput, aToolLetGoGlidesBackOntoTheRecording) {
  HandInput input;
  const auto recording = straightLine();
  input.restart(twoTools(), recording);
  double time = 0;
  for (int i = 0; i < 20; ++i) input.advance({{true, at(1.15)}}, time += kDt, kDt);
  double last = input.hands()[0].p_WB.x();
  EXPECT_EQ(last, 1.15);
  for (int i = 0; i < 400; ++i) {
    const double x = input.advance({{false, {}}}, time += kDt, kDt)[0].p_WB.x();
    ASSERT_LE(std::abs(x - last), HandInput::kGlideSpeed * kDt * (1 + 1e-9));
    last = x;
  }
  EXPECT_EQ(input.hands()[0].p_WB, handAt(recording->tracks[1], time).p_WB);
}

TEST(HandInput, knowsWhetherAllHandsAreOnTheRecordedPath) {
  HandInput input;
  input.restart(twoTools(), nullptr);
  input.advance({}, kDt, kDt);
  EXPECT_FALSE(input.onPath()) << "there is none";
  input.restart(twoTools(), straightLine());
  input.advance({}, kDt, kDt);
  EXPECT_TRUE(input.onPath());
  input.advance({{true, at(1.2)}}, 2 * kDt, kDt);
  EXPECT_FALSE(input.onPath());
  int steps = 2;
  while (!input.onPath() && steps < 1000) input.advance({}, ++steps * kDt, kDt);
  EXPECT_LT(steps, 1000) << "it has glided back";
  EXPECT_GT(steps, 3) << "which takes its time";
  input.advance({{}, {true, at(2.5)}}, ++steps * kDt, kDt);
  for (int i = 0; i < 100; ++i) input.advance({}, ++steps * kDt, kDt);
  EXPECT_FALSE(input.onPath()) << "a tool without a track stays where it was put";
}

TEST(HandInput, aToolLetGoWithoutRecordingStays) {
  HandInput input;
  input.restart(twoTools(), nullptr);
  double time = 0;
  for (int i = 0; i < 400; ++i) input.advance({{true, at(1.2)}}, time += kDt, kDt);
  EXPECT_EQ(input.advance({{false, {}}}, time += kDt, kDt)[0].p_WB.x(), 1.2);
}

TEST(HandInput, aChangedScenarioKeepsTheHandOfAToolThatStays) {
  HandInput input;
  Scenario scenario = twoTools();
  input.restart(scenario, nullptr);
  input.advance({{true, at(1.005)}}, kDt, kDt);
  scenario.tools.erase(scenario.tools.begin() + 1);
  Tool extra;
  extra.id = "finger";
  extra.home = at(7);
  scenario.tools.insert(scenario.tools.begin(), extra);
  input.change(scenario, nullptr);
  ASSERT_EQ(input.hands().size(), 2u);
  EXPECT_EQ(input.hands()[0].p_WB.x(), 7);
  EXPECT_EQ(input.hands()[1].p_WB.x(), 1.005);
}

TEST(HandInput, turnsAreBoundedToo) {
  const Pose half{Vec3::Zero(), Quat(Eigen::AngleAxisd(1.0, Vec3::UnitZ()))};
  const Pose next = approach(Pose{}, half, 1, 0.1);
  EXPECT_NEAR(next.q_WB.angularDistance(Quat::Identity()), 0.1, 1e-12);
}

}  // namespace
}  // namespace glenoid
