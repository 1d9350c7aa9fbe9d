// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <random>

#include "simcore/base/TripleBuffer.h"
#include "simcore/haptic/HapticLoop.h"
#include "simcore/haptic/RecordedHand.h"
#include "tests/simcore/haptic/Walls.h"
#include "tests/simcore/step/HeapCount.h"

namespace glenoid {
namespace {

LocalProblem anyProblem(std::mt19937& random, int rows) {
  std::uniform_real_distribution<double> any(-1, 1);
  LocalProblem problem = test::wall();
  problem.rowCount = rows;
  problem.overflow = rows / 8;
  for (int i = 0; i < rows; ++i) {
    problem.J.block<1, 3>(i, 0) = Vec3(any(random), 1, any(random)).normalized().transpose();
    problem.J.block<1, 3>(i, 3) = 0.01 * Vec3(any(random), any(random), any(random)).transpose();
    problem.slack[static_cast<std::size_t>(i)] = 1e-4 * any(random);
    problem.C(i, i) = 1e-4 * (1 + any(random));
  }
  return problem;
}

// From the first tick on: contact of every size, a hand that jumps, data lost, a simulation that falls silent.
TEST(HapticAllocation, aTickAllocatesNothing) {
  ASSERT_TRUE(test::heapIsCounted());
  HapticSettings settings;
  settings.device = unknownDevice();
  std::vector<HapticSample> log(2000);
  HapticLoop loop(settings);
  loop.setLog(log);
  HandTrack track;
  track.keys = {{0, test::handAtHeight(0.002)}, {1, test::handAtHeight(-0.003)}, {2, test::handAtHeight(0.002)}};
  RecordedHand hand(track, {}, 0, 0.005);
  TripleBuffer<LocalProblem> problems;
  std::mt19937 random(5);
  std::vector<LocalProblem> prepared;
  for (int rows = 0; rows <= LocalProblem::kRows; ++rows) prepared.push_back(anyProblem(random, rows));
  const long before = test::heapAllocations();
  for (std::int64_t k = 1; k <= 3000; ++k) {
    const std::int64_t now = k * 1'000'000;
    if (k % 5 == 0 && (k < 1500 || k > 1600)) {
      problems.back() = prepared[static_cast<std::size_t>(k / 5) % prepared.size()];
      problems.back().stamp = now;
      problems.publish();
    }
    problems.take();
    ToolInput input;
    const bool present = hand.read(now, input) && k % 400 > 10;
    if (k % 333 == 0) input.pose.p_WB.x() += 1;
    loop.tick(now, 0.001, present, input, problems.front());
  }
  EXPECT_EQ(test::heapAllocations() - before, 0);
  EXPECT_GT(loop.counts().forceMax, 0.1);
  EXPECT_GT(loop.counts().lost, 50);
  EXPECT_GT(loop.counts().silent, 20);
  EXPECT_EQ(loop.counts().rowsMax, LocalProblem::kRows);
}

}  // namespace
}  // namespace glenoid
