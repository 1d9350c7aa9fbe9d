// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/lab/StepSeries.h"

#include <gtest/gtest.h>

#include <cmath>

namespace glenoid {
namespace {

StepMeter::Reading readingOf(const std::vector<float>& milliseconds) {
  StepMeter::Reading reading;
  for (const float ms : milliseconds) {
    StepMeter::Step step;
    step.cpuMs = ms;
    step.stages[static_cast<int>(Stage::Collide)] = 0.25f * ms;
    step.stages[static_cast<int>(Stage::Contact)] = 0.5f * ms;
    reading.steps.push_back(step);
  }
  return reading;
}

TEST(StepSeries, percentilesAreOfAllStepsOfAHalfSecondByNearestRank) {
  StepSeries series;
  std::vector<float> steps;
  for (int k = 1; k <= 100; ++k) steps.push_back(static_cast<float>(k));
  series.add(10.0, readingOf(steps));
  series.add(10.6, readingOf({}));
  ASSERT_EQ(series.moments().size(), 1u);
  EXPECT_NEAR(series.moments()[0].p50, 50, 1);
  EXPECT_DOUBLE_EQ(series.moments()[0].p95, 95);
  EXPECT_NEAR(series.stages({Stage::Collide, Stage::Contact}).p95, 0.75 * 95, 1e-3) << "of sums, step by step";
  EXPECT_DOUBLE_EQ(series.step().p95, 95);
}

TEST(StepSeries, whereNothingRanThereIsAGap) {
  StepSeries series;
  series.add(0.0, readingOf({2, 2}));
  for (double now = 0.2; now < 3.0; now += 0.2) series.add(now, readingOf({}));
  series.add(3.0, readingOf({4}));
  series.add(3.6, readingOf({}));
  ASSERT_GE(series.moments().size(), 6u);
  EXPECT_DOUBLE_EQ(series.moments().front().p50, 2);
  EXPECT_TRUE(std::isnan(series.moments()[2].p50));
  EXPECT_TRUE(std::isnan(series.moments()[2].p95));
  EXPECT_DOUBLE_EQ(series.moments().back().p50, 4);
  series.add(10, readingOf({}));
  EXPECT_FALSE(series.hasSteps());
  EXPECT_TRUE(std::isnan(series.step().p50));
}

TEST(StepSeries, keepsTwoMinutes) {
  StepSeries series;
  for (double now = 0; now < 400; now += 0.25) series.add(now, readingOf({1}));
  EXPECT_LE(series.moments().back().at - series.moments().front().at, StepSeries::kKept);
  EXPECT_GT(series.moments().size(), 230u);
}

}  // namespace
}  // namespace glenoid
