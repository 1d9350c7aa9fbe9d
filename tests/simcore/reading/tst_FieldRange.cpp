// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/reading/FieldRange.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glenoid {
namespace {

TEST(FieldRange, theReachIgnoresTheFewAndTheHidden) {
  SurfaceValues values(3);
  for (int i = 0; i < 1000; ++i) values[0].push_back(static_cast<float>(i) / 100);  // 0 … 9.99
  for (int i = 0; i < 10; ++i) values[0][i] = 1e6f;
  values[2] = std::vector<float>(500, -50.0f);
  values[2][0] = NAN;
  EXPECT_NEAR(fieldReach(Quantity::Stress, values, std::vector<char>{0, 0, 1}), 9.89, 0.02);
  EXPECT_DOUBLE_EQ(fieldReach(Quantity::Pressure, values), 50) << "a sign does not matter";
  EXPECT_EQ(fieldReach(Quantity::Stress, values, std::vector<char>{1, 1, 1}), 0);
  values = {std::vector<float>(10000, 0.0f)};
  values[0][3] = 7;
  EXPECT_EQ(fieldReach(Quantity::Stress, values), 0);
  EXPECT_EQ(fieldReach(Quantity::Contact, values), 7) << "places without contact are no values";
}

TEST(FieldRange, endsAreRoundAndHoldTheReach) {
  EXPECT_EQ(rangeFor(Quantity::Stress, 23400), (FieldRange{0, 30000}));
  EXPECT_EQ(rangeFor(Quantity::Pressure, 900), (FieldRange{-1000, 1000}));
  EXPECT_EQ(rangeFor(Quantity::Contact, 5000), (FieldRange{0, 5000}));
  EXPECT_EQ(rangeFor(Quantity::Stress, 0), (FieldRange{0, 1000}));
  EXPECT_EQ(rangeFor(Quantity::Strain, 0), (FieldRange{0, 0.01}));
  for (double reach = 1e-4; reach < 1e7; reach *= 1.07) {
    const FieldRange range = rangeFor(Quantity::Stress, reach);
    EXPECT_GE(range.high, reach * (1 - 1e-9));
    EXPECT_LE(range.high, 1.51 * reach);
  }
}

TEST(FieldRange, anAutomaticScaleStaysWhileValuesMoveALittle) {
  SteadyRange steady;
  EXPECT_EQ(steady.follow(Quantity::Stress, 19).high, 20);
  // What swings about a round number would change the scale at each step.
  for (int i = 0; i < 20; ++i) EXPECT_EQ(steady.follow(Quantity::Stress, 20 + (i % 2 ? 1.5 : -1.5)).high, 20);
  EXPECT_EQ(steady.follow(Quantity::Stress, 11).high, 20);
  EXPECT_EQ(steady.follow(Quantity::Stress, 23).high, 30);
  EXPECT_EQ(steady.follow(Quantity::Stress, 9).high, 10);
  EXPECT_EQ(steady.follow(Quantity::Pressure, 9), (FieldRange{-10, 10})) << "another quantity, another scale";
  steady.forget();
  EXPECT_EQ(steady.follow(Quantity::Pressure, 5.5).high, 6);
}

TEST(FieldRange, ticksAreRoundAndWithin) {
  EXPECT_EQ(ticksIn({0, 30}), (std::vector<double>{0, 5, 10, 15, 20, 25, 30}));
  EXPECT_EQ(ticksIn({0, 20}), (std::vector<double>{0, 5, 10, 15, 20}));
  EXPECT_EQ(ticksIn({-8, 8}), (std::vector<double>{-8, -4, 0, 4, 8}));
  EXPECT_EQ(ticksIn({-1000, 1000}), (std::vector<double>{-1000, -500, 0, 500, 1000}));
  const std::vector<double> odd = ticksIn({0.013, 0.047});
  ASSERT_GE(odd.size(), 3u);
  EXPECT_NEAR(odd[0], 0.02, 1e-12);
  for (double high = 0.01; high < 1e6; high *= 1.31) {
    const auto ticks = ticksIn({0, high});
    EXPECT_GE(ticks.size(), 3u) << high;
    EXPECT_LE(ticks.size(), 7u) << high;
    EXPECT_LE(ticks.back(), high * (1 + 1e-8));
  }
  for (double reach = 1e-3; reach < 1e6; reach *= 1.17)
    for (const Quantity quantity : {Quantity::Stress, Quantity::Pressure}) {
      const FieldRange range = rangeFor(quantity, reach);
      const auto ticks = ticksIn(range);
      EXPECT_NEAR(ticks.front(), range.low, 1e-9 * range.high) << range.high;
      EXPECT_NEAR(ticks.back(), range.high, 1e-9 * range.high);
    }
  EXPECT_TRUE(ticksIn({1, 1}).empty());
  EXPECT_TRUE(ticksIn({0, INFINITY}).empty());
}

}  // namespace
}  // namespace glenoid
