// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "simcore/haptic/PortEnergy.h"
#include "tests/simcore/haptic/Walls.h"

namespace glenoid {
namespace {

using test::T;

/// A hand that goes into a sampled spring at x < 0 and out of it at an even speed v, n ticks each way.
double madeBy(double K, double b, double v, int n) {
  PortEnergy energy(b, T);
  double x = 0;
  for (const double way : {-1.0, 1.0})
    for (int i = 0; i < n; ++i) {
      const double held = x < -1e-12 ? -K * x : 0.0;
      energy.add(Vec3(held, 0, 0), Vec3(way * v * T, 0, 0), T);
      x += way * v * T;
    }
  return energy.worst();
}

// In and out of it the held force is half a tick late: each way gives out K T/2 · v² · time.
TEST(PortEnergy, aSampledSpringLeaksAsMuchAsItsHoldDoes) {
  const double K = 1000, v = 0.05;
  const int n = 100;
  EXPECT_NEAR(madeBy(K, 0, v, n), K * T / 2 * v * v * (2 * n * T), 1e-12);
}

TEST(PortEnergy, theDampingOfColgatesBoundTakesExactlyThat) {
  const double K = 1000;
  EXPECT_NEAR(madeBy(K, K * T / 2, 0.05, 100), 0, 1e-12);
  EXPECT_GT(madeBy(K, 0.9 * K * T / 2, 0.05, 100), 1e-5);
}

TEST(PortEnergy, whatIsStoredAndComesBackIsNotMade) {
  PortEnergy energy(0, T);
  // A spring without a hold: the mean force over each tick.
  double x = 0;
  for (int i = 0; i < 1000; ++i) {
    const double next = -0.01 * std::sin(std::numbers::pi * (i + 1) / 1000);
    energy.add(Vec3(-500 * (x + next), 0, 0), Vec3(next - x, 0, 0), T);
    x = next;
    EXPECT_LT(energy.worst(), 1e-9);
  }
}

TEST(PortEnergy, aWindowBeginsWithoutForceAndEndsAfterTenSeconds) {
  // One microjoule a tick for ever, with a rest in the beginning only: 10 s of it count.
  PortEnergy energy(0, T);
  energy.add(Vec3::Zero(), Vec3(1, 0, 0), T);
  for (int i = 0; i < 25'000; ++i) energy.add(Vec3(1, 0, 0), Vec3(1e-6, 0, 0), T);
  EXPECT_NEAR(energy.worst(), 10'000e-6, 2e-6);
}

TEST(PortEnergy, theWorstOfAllWindowsIsThatOfACheckByHand) {
  // Rests every 37 ticks and a work that goes up and down: against all pairs.
  PortEnergy energy(0, T);
  std::vector<double> sum{0};
  std::vector<bool> start;
  double worst = 0;
  for (int i = 0; i < 12'000; ++i) {
    const bool rest = i % 37 == 0;
    const double work = rest ? 0 : 1e-4 * std::sin(0.013 * i) - 2e-6 * (i % 5);
    energy.add(Vec3(rest ? 0 : 1, 0, 0), Vec3(rest ? 0.3 : work, 0, 0), T);
    start.push_back(rest);
    sum.push_back(sum.back() + work);
  }
  for (std::size_t from = 0; from < start.size(); ++from)
    if (start[from])
      for (std::size_t to = from + 1; to < sum.size() && to <= from + 10'001; ++to) worst = std::max(worst, sum[to] - sum[from]);
  EXPECT_NEAR(energy.worst(), worst, 1e-12);
}

}  // namespace
}  // namespace glenoid
