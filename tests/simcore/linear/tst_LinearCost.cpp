// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <numeric>

#include "simcore/linear/BlockCholesky.h"
#include "simcore/linear/Kernels.h"
#include "simcore/linear/ReferenceCholesky.h"
#include "tests/simcore/linear/Problems.h"

namespace glenoid::test {
namespace {

/// Median of `runs` wall times after a warm-up, µs.
template <class Work>
double medianMicroseconds(int runs, Work&& work) {
  std::vector<double> times;
  for (int run = 0; run < runs + 5; ++run) {
    const auto start = std::chrono::steady_clock::now();
    work();
    const std::chrono::duration<double, std::micro> spent = std::chrono::steady_clock::now() - start;
    if (run >= 5) times.push_back(spent.count());
  }
  std::nth_element(times.begin(), times.begin() + runs / 2, times.end());
  return times[static_cast<std::size_t>(runs / 2)];
}

}  // namespace

// Prints what a step of the shoulder's size pays for; asserts only a ratio inside the same run, with a wide
// margin (the design expects about ten), because the machine may be shared.
TEST(LinearCost, atShoulderSize) {
  const ShoulderSize problem = shoulderSize();
  const int blocks = problem.symbolic->blockCount();
  std::printf("%d tetrahedra, %d blocks, %zu of A, %d of L, %ld block updates\n", problem.tetrahedra, blocks,
              problem.symbolic->stored().size(), problem.symbolic->slotCount(),
              problem.symbolic->updateCount());
  VecX x = VecX::Ones(3 * blocks);
  [[maybe_unused]] double fastFactor = 0.0;  // a build with assertions checks no ratio
  for (const bool portable : {false, true}) {
    BlockCholesky cholesky(problem.symbolic, portable);
    ASSERT_TRUE(cholesky.factor(*problem.A));
    const double factor = medianMicroseconds(101, [&] { ASSERT_TRUE(cholesky.factor(*problem.A)); });
    const double solve = medianMicroseconds(101, [&] {
      x.setOnes();
      cholesky.solve(x);
    });
    std::printf("%-9s factor %.0f us, solve %.0f us\n", kernelIsaName(portable), factor, solve);
    if (!portable) fastFactor = factor;
    for (const int count : {65, 153, 195}) {
      const auto rows = problem.contactRows(count, 300);
      const std::vector<SparseRow> J = asRows(rows);
      std::vector<int> ids(static_cast<std::size_t>(count));
      std::iota(ids.begin(), ids.end(), 0);
      const std::vector<double> lambda(static_cast<std::size_t>(count), 1.0);
      RowPanels panels;
      MatX W = MatX::Zero(count, count);
      const double half = medianMicroseconds(51, [&] { cholesky.halfSolve(J, panels); });
      const double delassus = medianMicroseconds(51, [&] { cholesky.addDelassus(panels, ids, W); });
      const double impulses = medianMicroseconds(51, [&] { cholesky.addImpulses(panels, lambda, x); });
      std::printf("%-9s %d rows: half solve %.0f us (%d blocks), W %.0f us, impulses %.0f us\n",
                  kernelIsaName(portable), count, half, panels.storedBlocks(), delassus, impulses);
    }
  }
  ReferenceCholesky reference(problem.symbolic);
  const double factor = medianMicroseconds(21, [&] { ASSERT_TRUE(reference.factor(*problem.A)); });
  const double solve = medianMicroseconds(21, [&] {
    x.setOnes();
    reference.solve(x);
  });
  std::printf("CHOLMOD   factor %.0f us, solve with two refinements %.0f us\n", factor, solve);
  VecX y(3 * blocks);
  std::printf("multiply  %.1f us\n", medianMicroseconds(101, [&] { problem.A->multiply(x, y); }));
#ifdef NDEBUG
  EXPECT_LT(fastFactor, 1.5 * factor);
#endif
}

}  // namespace glenoid::test
