// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <memory>
#include <random>

#include "simcore/haptic/TickTimes.h"

namespace glenoid {
namespace {

TEST(TickTimes, percentilesAreThoseOfTheSortedTimes) {
  const auto times = std::make_unique<TickTimes>();
  std::mt19937 random(7);
  std::vector<double> us;
  for (int i = 0; i < 10'000; ++i) {
    const std::int64_t ns = i % 500 == 0 ? 3'000'000 : static_cast<std::int64_t>(random() % 90'000);
    times->add(ns);
    us.push_back(1e-3 * static_cast<double>(ns));
  }
  std::sort(us.begin(), us.end());
  for (const double share : {0.5, 0.99, 0.999}) {
    const double exact = us[static_cast<std::size_t>(std::ceil(share * 10'000)) - 1];
    EXPECT_GE(times->percentileUs(share), exact);
    EXPECT_LE(times->percentileUs(share), exact + 1);
  }
  EXPECT_DOUBLE_EQ(times->worstUs(), 3000);
  EXPECT_EQ(times->total(), 10'000);
}

TEST(TickTimes, whatIsBeyondItsReachIsTheWorst) {
  const auto times = std::make_unique<TickTimes>();
  EXPECT_EQ(times->percentileUs(0.99), 0);
  times->add(75'000'000);
  EXPECT_DOUBLE_EQ(times->percentileUs(0.5), 75'000);
}

}  // namespace
}  // namespace glenoid
