// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <limits>

#include "simcore/haptic/HapticLoop.h"
#include "tests/simcore/haptic/Walls.h"

namespace glenoid {
namespace {

using test::kMs;
using test::T;

HapticSettings settings() {
  HapticSettings all;
  all.device = unknownDevice();
  all.device.damping = 2;
  all.device.forceMax = 10;
  all.device.slewMax = 1e6;
  return all;
}

/// A loop with a hand at a depth in a wall, a tick every millisecond, the simulation speaking every fifth.
struct Pressed {
  HapticLoop loop{settings()};
  LocalProblem problem = test::wall();
  ToolInput input;
  std::int64_t now = 0;
  bool speaks = true;

  explicit Pressed(double depth) { input.pose = test::handAtHeight(-depth); }
  Vec3 tick(bool present = true) {
    now += kMs;
    if (present) input.stamp = now;
    if (speaks && now % (5 * kMs) == 0) problem.stamp = now;
    return loop.tick(now, T, present, input, problem).force;
  }
};

TEST(HapticLoop, showsTheSpringOfTheScenarioWhereTheDeviceCan) {
  Pressed pressed(0.002);
  EXPECT_NEAR(pressed.tick().y(), 800 * 0.002, 1e-9);
  EXPECT_EQ(pressed.loop.counts().gains.limit, GainLimit::Wish);
}

TEST(HapticLoop, aScenarioStifferThanTheDeviceSaturatesAndSaysSo) {
  Pressed pressed(0.0005);
  pressed.problem.stiffness = 1e5;
  pressed.tick();
  EXPECT_EQ(pressed.loop.counts().gains.limit, GainLimit::Damping);
  EXPECT_NEAR(pressed.tick().y(), 3600 * 0.0005, 1e-9);
}

TEST(HapticLoop, aWildDeviceIsNoForceAndComesBackWithoutAJump) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Vec3& wild : {Vec3(nan, 0, 0), Vec3(1e30, 0, 0), Vec3(0.5, 0, 0)}) {
    Pressed pressed(0.002);
    for (int i = 0; i < 5; ++i) pressed.tick();
    const Pose good = pressed.input.pose;
    for (int i = 0; i < 5; ++i) {
      pressed.input.pose.p_WB = good.p_WB + (i % 2 ? Vec3(0, 0, 0) : wild);  // now wild, now as if nothing had been
      EXPECT_TRUE(pressed.tick().allFinite());
    }
    EXPECT_EQ(pressed.loop.counts().force, Vec3(0, 0, 0)) << wild.transpose();
    EXPECT_EQ(pressed.loop.counts().lost, 5) << wild.transpose();
    pressed.input.pose = good;
    for (int i = 0; i < HapticLoop::kTrustAfter; ++i) EXPECT_EQ(pressed.tick(), Vec3(0, 0, 0)) << "not believed at once";
    double last = 0;
    for (int i = 0; i < 60; ++i) {
      const double force = pressed.tick().y();
      EXPECT_LE(force - last, 1.6 / 50 + 1e-9);
      last = force;
    }
    EXPECT_NEAR(last, 1.6, 1e-9);
  }
}

TEST(HapticLoop, aDeviceThatIsGoneIsNoForceWithinFiveMilliseconds) {
  Pressed pressed(0.002);
  for (int i = 0; i < 5; ++i) pressed.tick();
  for (int i = 0; i < 5; ++i) pressed.tick(false);
  EXPECT_EQ(pressed.loop.counts().force, Vec3(0, 0, 0));
}

TEST(HapticLoop, aSimulationThatFallsSilentFadesAfterTwentyMilliseconds) {
  Pressed pressed(0.002);
  for (int i = 0; i < 10; ++i) pressed.tick();
  pressed.speaks = false;
  for (int i = 0; i < 20; ++i) EXPECT_NEAR(pressed.tick().y(), 1.6, 1e-9) << i;
  for (int i = 0; i < 5; ++i) pressed.tick();
  EXPECT_EQ(pressed.loop.counts().force, Vec3(0, 0, 0));
  EXPECT_EQ(pressed.loop.counts().silent, 5);
  pressed.speaks = true;
  for (int i = 0; i < 60; ++i) pressed.tick();
  EXPECT_NEAR(pressed.loop.counts().force.y(), 1.6, 1e-9);
}

TEST(HapticLoop, rowsWithoutAPlaceAreCounted) {
  Pressed pressed(0.002);
  pressed.tick();
  pressed.problem.overflow = 7;
  pressed.tick();
  pressed.tick();
  EXPECT_EQ(pressed.loop.counts().overflow, 2);
  EXPECT_EQ(pressed.loop.counts().overflowMax, 7);
}

TEST(HapticLoop, keepsASampleOfEachTickWhileThereIsRoom) {
  std::vector<HapticSample> log(3);
  Pressed pressed(0.002);
  pressed.loop.setLog(log);
  for (int i = 0; i < 5; ++i) pressed.tick();
  EXPECT_EQ(pressed.loop.logged(), 3u);
  EXPECT_EQ(log[2].time, 3 * kMs);
  EXPECT_NEAR(log[2].shown.y(), 1.6, 1e-9);
}

}  // namespace
}  // namespace glenoid
