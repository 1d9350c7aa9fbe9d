// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "simcore/live/SessionRecorder.h"

namespace glenoid {
namespace {

Scenario oneTool() {
  Scenario scenario;
  Tool tool;
  tool.id = "probe";
  tool.home.p_WB = Vec3(0, 1, 0);
  scenario.tools = {tool};
  return scenario;
}

TEST(SessionRecorder, givesBackEveryHandAndKeepsARestShort) {
  const Scenario scenario = oneTool();
  SessionRecorder session;
  session.restart(scenario);
  std::vector<Pose> hands{scenario.tools[0].home}, all;
  for (long step = 1; step <= 1000; ++step) {
    if (step > 400 && step <= 500) hands[0].p_WB.x() += 1e-4 / 3.0;
    if (step == 700) hands[0].q_WB = Quat(Eigen::AngleAxisd(0.1, Vec3::UnitX())) * hands[0].q_WB;
    session.add(step, hands);
    all.push_back(hands[0]);
  }
  const Recording recording = session.recording();
  EXPECT_EQ(recording.steps, 1000);
  ASSERT_EQ(recording.tracks.size(), 1u);
  EXPECT_LT(recording.tracks[0].keys.size(), 110u);
  for (long step = 1; step <= 1000; ++step) {
    const Pose hand = handAt(recording.tracks[0], static_cast<double>(step) * scenario.dt), &wanted = all[static_cast<std::size_t>(step - 1)];
    ASSERT_EQ(hand.p_WB, wanted.p_WB) << step;
    ASSERT_EQ(hand.q_WB.coeffs(), wanted.q_WB.coeffs()) << step;
  }
}

TEST(SessionRecorder, isNoLongerWholeOnceTheModelChanged) {
  SessionRecorder session;
  EXPECT_FALSE(session.isWhole());
  session.restart(oneTool());
  EXPECT_TRUE(session.isWhole());
  session.interrupt();
  EXPECT_FALSE(session.isWhole());
  session.restart(oneTool());
  EXPECT_TRUE(session.isWhole());
}

}  // namespace
}  // namespace glenoid
