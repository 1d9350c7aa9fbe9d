// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>

#include "simcore/haptic/EnergyTank.h"
#include "simcore/haptic/HapticLoop.h"
#include "tests/simcore/haptic/Walls.h"

namespace glenoid {
namespace {

using test::T;

TEST(EnergyTank, givesBackWhatWasPutInAndNoMore) {
  EnergyTank tank(0, 1);
  double given = 0;
  for (int i = 0; i < 100; ++i) tank.add(Vec3(2, 0, 0), Vec3(-1e-4, 0, 0), T, false);  // 20 mJ put in
  for (int i = 0; i < 400; ++i) {  // on the way out 5 N: 50 mJ if they were let
    const Vec3 shown = tank.limit(Vec3(5, 0, 0), Vec3(0.1, 0, 0), T);
    tank.add(shown, Vec3(1e-4, 0, 0), T, false);
    given += 1e-4 * shown.x();
  }
  EXPECT_GT(given, 0.0199);
  EXPECT_LE(given, 0.02 + 1.05 * EnergyTank::kCredit);
}

TEST(EnergyTank, inDebtItStopsAHandAndThrowsItNotBack) {
  EnergyTank tank(0, 0.1);
  for (int i = 0; i < 1000; ++i) tank.add(Vec3(1, 0, 0), Vec3(1e-5, 0, 0), T, false);
  EXPECT_LT(tank.left(), 0);
  // Comes in at 10 mm/s: 1 N stops 0.1 kg of it in a tick, 2 N send it back as fast as it came, which costs nothing.
  EXPECT_EQ(tank.limit(Vec3(1.5, 0, 0), Vec3(-0.01, 0, 0), T), Vec3(1.5, 0, 0));
  EXPECT_FALSE(tank.cut());
  EXPECT_NEAR(tank.limit(Vec3(5, 0, 0), Vec3(-0.01, 0, 0), T).x(), 2, 1e-9);
  EXPECT_TRUE(tank.cut());
  EXPECT_LT(tank.limit(Vec3(5, 0, 0), Vec3(0.01, 0, 0), T).norm(), 1e-9);
  EXPECT_LT(tank.limit(Vec3(5, 0, 0), Vec3::Zero(), T).norm(), 1e-9);
}

TEST(EnergyTank, keepsDebtsOverOpenMomentsAndNoCredits) {
  EnergyTank tank(0, 0.1);
  tank.add(Vec3(2, 0, 0), Vec3(-0.01, 0, 0), T, false);
  tank.add(Vec3::Zero(), Vec3(0.01, 0, 0), T, true);
  EXPECT_DOUBLE_EQ(tank.left(), EnergyTank::kCredit);
  tank.add(Vec3(2, 0, 0), Vec3(0.001, 0, 0), T, false);
  tank.add(Vec3::Zero(), Vec3(0.01, 0, 0), T, true);
  EXPECT_NEAR(tank.left(), EnergyTank::kCredit - 0.002, 1e-6);
}

/// A hand that goes 5 mm into a wall and out again at 0.1 m/s, without a word of the simulation on the way in from `silentFrom` to
/// `silentTo` (s). What the loop's own book says was made, J.
double madeInAndOut(double silentFrom, double silentTo, HapticCounts* counts) {
  HapticSettings settings;
  settings.device = unknownDevice();
  settings.device.damping = 1;
  settings.device.forceMax = 20;
  settings.device.slewMax = 20000;
  HapticLoop loop(settings);
  LocalProblem wall = test::wall();
  wall.dt = 0.005;
  ToolInput input;
  for (int k = 0; k < 400; ++k) {
    const double time = k * T, depth = 0.005 - std::abs(0.1 * (time - 0.2) );
    input.pose = test::handAtHeight(-std::max(-0.005, depth));
    input.stamp = static_cast<std::int64_t>(1e9 * time);
    if (time < silentFrom || time >= silentTo) wall.stamp = input.stamp;
    loop.tick(input.stamp, T, true, input, wall);
  }
  *counts = loop.counts();
  return loop.counts().energyMax;
}

TEST(EnergyTank, aSilenceAtDepthIsNoSourceOfEnergy) {
  HapticCounts counts;
  // Silent while it stays deep: what comes back is what was put in, and the book knows it.
  EXPECT_LT(madeInAndOut(0.18, 0.22, &counts), 1e-3);
  EXPECT_GT(counts.forceMax, 2);
  // Silent nearly all the way in: nothing was put in, so nothing may come back.
  EXPECT_LT(madeInAndOut(0.12, 0.205, &counts), 1e-3);
  EXPECT_GT(counts.silent, 20);
  EXPECT_GT(counts.heldBack, 5);
  // Never silent: not touched.
  EXPECT_LT(madeInAndOut(9, 9, &counts), 1e-6);
  EXPECT_EQ(counts.heldBack, 0);
}

}  // namespace
}  // namespace glenoid
