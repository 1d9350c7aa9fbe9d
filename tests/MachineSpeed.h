// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <algorithm>
#include <ctime>
#include <random>
#include <vector>

namespace glenoid::test {

/// What this machine takes to sort four million numbers, s of processor time: 0.3 to 0.45 where the bounds of our tests were
/// found. A bound in seconds alone would judge the machine and who else works on it.
inline double sortingSeconds() {
  std::mt19937_64 random(1);
  std::vector<double> numbers(4000000);
  for (double& x : numbers) x = static_cast<double>(random());
  const std::clock_t start = std::clock();
  std::sort(numbers.begin(), numbers.end());
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// By how much slower than there it is now; at least 1.
inline double slowness() { return std::max(1.0, sortingSeconds() / 0.43); }

}  // namespace glenoid::test
