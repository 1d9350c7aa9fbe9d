// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/live/StepClock.h"

#include <gtest/gtest.h>

namespace glenoid {
namespace {

TEST(StepClock, onTimeTakesOneStepEachInterval) {
  StepClock clock(4);
  clock.restart(10.0, 0.005);
  int steps = 0;
  for (int ms = 0; ms < 1000; ++ms) steps += clock.stepsDue(10.0 + 0.001 * ms + 0.0005);
  EXPECT_EQ(steps, 200);
  EXPECT_EQ(clock.forgiven(), 0);
}

TEST(StepClock, aShortDelayIsCaughtUpCompletely) {
  StepClock clock(4);
  clock.restart(0, 0.005);
  EXPECT_EQ(clock.stepsDue(0.0001), 1);
  EXPECT_EQ(clock.stepsDue(0.0176), 3);  // due at 5, 10 and 15 ms
  EXPECT_EQ(clock.forgiven(), 0);
  EXPECT_NEAR(clock.nextDue(), 0.020, 1e-12);
}

TEST(StepClock, aLongDelayIsBoundedAndForgiven) {
  StepClock clock(4);
  clock.restart(0, 0.005);
  EXPECT_EQ(clock.stepsDue(0.0001), 1);
  EXPECT_EQ(clock.stepsDue(1.0001), 4);
  // 199 further steps were due; the four taken are not forgiven, and the phase stays.
  EXPECT_NEAR(clock.forgiven(), (200 - 4) * 0.005, 0.0051);
  EXPECT_LE(clock.stepsDue(1.0002), 1);
  EXPECT_GT(clock.nextDue(), 1.0002);
}

TEST(StepClock, alwaysLateStillRunsEveryStepAndNeverMoreThanTheBound) {
  StepClock clock(3);
  clock.restart(0, 0.005);
  double now = 0;
  for (int i = 0; i < 100; ++i) {
    const int due = clock.stepsDue(now);
    ASSERT_GE(due, 1);
    ASSERT_LE(due, 3);
    now += due * 0.020;  // each step costs four times its length
  }
  EXPECT_GT(clock.forgiven(), 0.7 * now);
}

}  // namespace
}  // namespace glenoid
