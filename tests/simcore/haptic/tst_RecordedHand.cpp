// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "simcore/haptic/RecordedHand.h"
#include "tests/simcore/haptic/Walls.h"

namespace glenoid {
namespace {

HandTrack evenTrack() {
  HandTrack track;
  track.tool = "probe";
  track.keys = {{0, {Vec3::Zero(), Quat::Identity()}}, {10, {Vec3(1, 0, 0), Quat::Identity()}}};
  return track;
}
using test::kMs;

TEST(RecordedHand, goesByTheClockAheadByItsLead) {
  const HandTrack track = evenTrack();
  RecordedHand hand(track, {}, 50 * kMs, 0.005);
  ToolInput input;
  ASSERT_TRUE(hand.read(50 * kMs, input));
  EXPECT_NEAR(input.pose.p_WB.x(), 0.0005, 1e-12);
  ASSERT_TRUE(hand.read(1050 * kMs, input));
  EXPECT_NEAR(input.pose.p_WB.x(), 0.1005, 1e-12);
  EXPECT_EQ(input.stamp, 1050 * kMs);
}

TEST(RecordedHand, waitsForARunThatFellBehindWithoutAJump) {
  const HandTrack track = evenTrack();
  RecordedHand hand(track, {}, 0, 0);
  ToolInput input;
  hand.read(1000 * kMs, input);
  hand.setBehind(0.1);
  double last = hand.trackTime();
  for (int ms = 1001; ms <= 1300; ++ms) {
    hand.read(ms * kMs, input);
    EXPECT_GE(hand.trackTime(), last + 0.0004999);
    EXPECT_LE(hand.trackTime(), last + 0.0010001);
    last = hand.trackTime();
  }
  EXPECT_NEAR(last, 1.3 - 0.1, 1e-9);
}

TEST(RecordedHand, withoutKeysStaysAtHome) {
  HandTrack track;
  RecordedHand hand(track, {Vec3(1, 2, 3), Quat::Identity()}, 0, 0);
  ToolInput input;
  ASSERT_TRUE(hand.read(kMs, input));
  EXPECT_EQ(input.pose.p_WB, Vec3(1, 2, 3));
}

}  // namespace
}  // namespace glenoid
