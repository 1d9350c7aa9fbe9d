// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "simcore/haptic/ForceGuard.h"
#include "tests/simcore/haptic/Walls.h"

namespace glenoid {
namespace {

using test::T;
constexpr double kGone = std::numeric_limits<double>::infinity();
GuardLimits limits() {
  GuardLimits all;
  all.forceMax = 3;
  all.slewMax = 1000;
  return all;
}
/// A guard that shows 2 N along X.
ForceGuard pressing() {
  ForceGuard guard(limits());
  for (int i = 0; i < 5; ++i) guard.show(Vec3(2, 0, 0), 0, 0, 0.005, T);
  EXPECT_EQ(guard.shown(), Vec3(2, 0, 0));
  return guard;
}

TEST(ForceGuard, letsThroughWhatIsWithinItsLimits) {
  ForceGuard guard(limits());
  EXPECT_EQ(guard.show(Vec3(0.4, 0.5, -0.3), 0, 0, 0.005, T), Vec3(0.4, 0.5, -0.3));
  EXPECT_FALSE(guard.word().clamped || guard.word().slewed || guard.word().lost || guard.word().silent);
}

TEST(ForceGuard, cutsTheChangeThenTheForceAndKeepsTheDirection) {
  ForceGuard guard(limits());
  EXPECT_LT((guard.show(Vec3(6, 8, 0), 0, 0, 0.005, T) - Vec3(0.6, 0.8, 0)).norm(), 1e-12);  // 1 N in a tick
  EXPECT_TRUE(guard.word().slewed && guard.word().clamped);
  for (int i = 0; i < 10; ++i) guard.show(Vec3(6, 8, 0), 0, 0, 0.005, T);
  EXPECT_LT((guard.shown() - Vec3(1.8, 2.4, 0)).norm(), 1e-12);  // 3 N
  EXPECT_TRUE(guard.word().clamped);
  EXPECT_FALSE(guard.word().slewed);
}

// The device's last word at time 0, a tick every millisecond after it.
TEST(ForceGuard, lostDataAreNoForceFiveMillisecondsAfterTheLastWord) {
  ForceGuard guard = pressing();
  double last = 2;
  for (int ms = 1; ms <= 8; ++ms) {
    const double shown = guard.show(Vec3(2, 0, 0), ms * T, 0, 0.005, T).x();
    EXPECT_LE(shown, last);
    if (ms <= 2) {
      EXPECT_EQ(shown, 2) << ms;
    } else if (ms >= 5) {
      EXPECT_EQ(shown, 0) << ms;
    } else {
      EXPECT_GT(shown, 0) << "a ramp, no step";
    }
    last = shown;
  }
  EXPECT_TRUE(guard.word().lost);
}

TEST(ForceGuard, aDeviceThatIsGoneIsRampedAtOnce) {
  ForceGuard guard = pressing();
  for (int ms = 1; ms <= 5; ++ms) guard.show(Vec3(2, 0, 0), kGone, 0, 0.005, T);
  EXPECT_EQ(guard.shown(), Vec3(0, 0, 0));
}

TEST(ForceGuard, aForceThatIsNoNumberNeverReachesAHand) {
  ForceGuard guard = pressing();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (int ms = 1; ms <= 5; ++ms) EXPECT_TRUE(guard.show(Vec3(nan, 0, 0), 0, 0, 0.005, T).allFinite());
  EXPECT_EQ(guard.shown(), Vec3(0, 0, 0));
}

TEST(ForceGuard, aSilentSimulationIsHeldTwentyMillisecondsOrThreeStepsThenRamped) {
  for (const auto& [dt, patience] : {std::pair{0.005, 20}, {0.02, 60}}) {
    ForceGuard guard = pressing();
    for (int ms = 1; ms <= patience; ++ms) EXPECT_EQ(guard.show(Vec3(2, 0, 0), 0, ms * T, dt, T).x(), 2) << dt << " " << ms;
    double last = 2;
    for (int ms = patience + 1; ms <= patience + 5; ++ms) {
      const double shown = guard.show(Vec3(2, 0, 0), 0, ms * T, dt, T).x();
      EXPECT_LT(shown, last);
      last = shown;
    }
    EXPECT_EQ(last, 0) << dt;
    EXPECT_TRUE(guard.word().silent);
  }
}

TEST(ForceGuard, dataLostWhileItFadesShortenTheFade) {
  ForceGuard guard = pressing();
  guard.show(Vec3(2, 0, 0), 0, 0.021, 0.005, T);
  for (int ms = 1; ms <= 3; ++ms) guard.show(Vec3(2, 0, 0), kGone, 0.021, 0.005, T);
  EXPECT_EQ(guard.shown(), Vec3(0, 0, 0));
}

TEST(ForceGuard, whatComesBackRisesEvenlyInFiftyMilliseconds) {
  ForceGuard guard = pressing();
  for (int ms = 0; ms < 10; ++ms) guard.show(Vec3(2, 0, 0), kGone, 0, 0.005, T);
  for (int ms = 1; ms <= 60; ++ms) EXPECT_NEAR(guard.show(Vec3(2, 0, 0), 0, 0, 0.005, T).x(), 2 * std::min(1.0, ms / 50.0), 1e-12);
}

// A moment's silence takes away a part, and no more than that has to come back.
TEST(ForceGuard, whatHadFadedInPartComesBackFromThere) {
  ForceGuard guard = pressing();
  const double faded = guard.show(Vec3(2, 0, 0), kGone, 0, 0.005, T).x();
  EXPECT_NEAR(faded, 2 * 2 / 3.0, 1e-9);
  EXPECT_NEAR(guard.show(Vec3(2, 0, 0), 0, 0, 0.005, T).x(), faded + 2 / 50.0, 1e-9);
}

// Missed ticks make the next one longer: a ramp keeps to the clock, not to the count.
TEST(ForceGuard, rampsKeepToTheClockWhenTicksAreMissed) {
  ForceGuard guard = pressing();
  guard.show(Vec3(2, 0, 0), kGone, 0, 0.005, 0.004);
  EXPECT_EQ(guard.shown(), Vec3(0, 0, 0));
}

}  // namespace
}  // namespace glenoid
