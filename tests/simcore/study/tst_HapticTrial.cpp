// SPDX-License-Identifier: GPL-3.0-or-later
// The whole chain in a time of its own: hand, device, loop, published problems, simulation. What haptics is held to.
#include <gtest/gtest.h>

#include <algorithm>

#include "simcore/step/Stepper.h"
#include "simcore/study/HapticBench.h"

namespace glenoid {
namespace {

DeviceProfile bench() {
  DeviceProfile device = unknownDevice();
  device.id = "bench";
  device.damping = 2;
  device.mass = 0.1;
  return device;
}

HapticTrialResult run(HapticTrial trial) {
  const auto result = runHapticTrial(trial);
  EXPECT_TRUE(result) << (result ? "" : toLogLine(result.error()));
  return result ? *result : HapticTrialResult();
}

TEST(HapticTrial, makesNoEnergyAndRendersTheBoundOnEverySurfaceAtEveryDelay) {
  const HapticBars bars;
  for (const HapticSurface surface : kHapticSurfaces)
    for (const double delay : {0.0, 0.001, 0.002, 0.005}) {
      HapticTrial trial;
      trial.surface = surface;
      trial.device = bench();
      trial.delay = delay;
      trial.seconds = 5;
      const HapticTrialResult result = run(trial);
      const std::string where = std::string(hapticSurfaceName(surface)) + " " + std::to_string(delay);
      EXPECT_LE(result.energyMade, bars.energy) << where;
      EXPECT_GT(result.forceMax, 0.5) << where << ": it was pressed at all";
      EXPECT_EQ(result.counts.inexact, 0) << where;
      EXPECT_EQ(result.counts.heldBack, 0) << where << ": nothing is kept from a hand whose problems come in time";
      EXPECT_NE(result.gains.limit, GainLimit::Wish) << where;
      if (surface == HapticSurface::Bone) {
        EXPECT_GE(result.renderedStiffness, bars.stiffnessShare * result.gains.bound) << where;
        EXPECT_LE(result.renderedStiffness, result.gains.bound) << where;
      }
    }
}

TEST(HapticTrial, feelsWhatTheExactStepFeelsOnTheSamePath) {
  const HapticBars bars;
  for (const HapticSurface surface : kHapticSurfaces) {
    HapticTrial trial;
    trial.surface = surface;
    trial.device = bench();
    trial.seconds = 2.5;
    trial.compare = true;
    const HapticTrialResult result = run(trial);
    EXPECT_LE(result.forceError, std::max(bars.forceError, bars.forceErrorShare * result.forceRms)) << hapticSurfaceName(surface);
    if (surface != HapticSurface::Bone) continue;
    EXPECT_LT(result.forceErrorShare, 1e-6) << "nothing there gives: the loop is the exact step";
  }
}

// Against figures that no haptic code made: a hand that has come to rest feels the contact force that the step reports.
TEST(HapticTrial, atRestTheHandFeelsTheContactForceOfTheStep) {
  for (const HapticSurface surface : kHapticSurfaces) {
    const CouplingGains gains{1500, 0.2, 4000, GainLimit::Damping};
    std::vector<Vec3> path;
    for (int k = 0; k < 1200; ++k) path.push_back(Vec3(0.0017, 0.001 - 0.003 * std::min(1.0, k / 400.0), 0.0023));
    const auto felt = exactHapticForces(surface, gains, 0.001, path);
    ASSERT_TRUE(felt);
    const auto model = makeHapticScene(surface, gains.stiffness, 0.001, path.front());
    ASSERT_TRUE(model);
    Stepper stepper(*model, {});
    State state = (*model)->start;
    Inputs inputs;
    inputs.hands = {(*model)->scenario.tools[0].home};
    Vec3 force = Vec3::Zero();
    for (std::size_t k = 1; k < path.size(); ++k) {
      inputs.hands[0].p_WB = path[k];
      force = stepper.step(inputs, state).toolForces[0];
    }
    EXPECT_GT(force.y(), 0.2) << hapticSurfaceName(surface);
    EXPECT_LT((felt->back() - force).norm(), 0.002 * force.norm()) << hapticSurfaceName(surface) << " " << felt->back().transpose() << " | " << force.transpose();
  }
}

// A simulation that stands still: forces fade, the hand goes on, they come back. What was never put in is not given. Without added delay: the
// tank books forces when they are sent, and with 5 ms until they act bone gives 7 mJ (simcore/haptic/README.md, Limits).
TEST(HapticTrial, makesNoEnergyWhenForcesFadeAndComeBack) {
  const HapticBars bars;
  for (const HapticSurface surface : kHapticSurfaces) {
    HapticTrial trial;
    trial.surface = surface;
    trial.device = bench();
    trial.seconds = 5;
    trial.silentEvery = 0.35;
    trial.silentFor = 0.06;
    const HapticTrialResult result = run(trial);
    EXPECT_GT(result.counts.silent, 100);
    EXPECT_GT(result.forceMax, 0.5);
    EXPECT_LE(result.energyMade, bars.energy) << hapticSurfaceName(surface);
  }
}

// The bars can be missed: a device that has a tenth of the damping it claims is given energy.
TEST(HapticTrial, aDeviceThatClaimsTooMuchDampingIsFoundOut) {
  DeviceProfile claims = bench();
  const CouplingGains gains = gainsFor(claims, 1e9, 1000, 0.005);
  VirtualHandSettings settings;
  settings.deviceDamping = 0.1 * claims.damping;
  settings.damping = 0;
  settings.delay = 0.005;
  VirtualHand hand(settings, Vec3(0, 0.004, 0));
  LocalProblem wall;
  wall.valid = true;
  wall.bodyCount = wall.rowCount = 1;
  wall.forceMax = wall.torqueMax = 1e300;
  wall.J(0, 1) = 1;
  LocalProxy proxy;
  for (int k = 0; k < 10'000; ++k) {
    const Vec3 target(0, k % 2000 < 1000 ? -0.006 : 0.004, 0);
    hand.tick(proxy.solve(wall, {hand.position(), Quat::Identity()}, {gains.stiffness, gains.damping, 1, 0}, 0.001, 0).force, target, Vec3::Zero());
  }
  EXPECT_GT(hand.energyMade(), HapticBars().energy);
}

TEST(HapticTrial, repeatsToTheLastBit) {
  HapticTrial trial;
  trial.device = bench();
  trial.seconds = 2.5;
  const HapticTrialResult once = run(trial), again = run(trial);
  ASSERT_EQ(once.wanted.size(), again.wanted.size());
  for (std::size_t k = 0; k < once.wanted.size(); ++k) ASSERT_EQ(once.wanted[k], again.wanted[k]) << k;
}

TEST(HapticBench, theZWidthTableHoldsWhatIsChosenBelowWhatIsPassive) {
  const StudyTable table = zWidthTable(bench(), {0, 0.002});
  int chosen = 0;
  for (const auto& row : table.rows) {
    EXPECT_LE(std::get<double>(row[3]), std::get<double>(row[2]) * (1 + 1e-5));
    if (std::holds_alternative<std::monostate>(row[4])) continue;
    ++chosen;
    EXPECT_LE(std::get<double>(row[4]), std::get<double>(row[3]) * (1 + 1e-6));
  }
  EXPECT_EQ(chosen, 2);
}

}  // namespace
}  // namespace glenoid
