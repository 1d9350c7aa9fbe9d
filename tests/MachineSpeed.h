// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <ctime>
#include <random>
#include <vector>

/// A bound in seconds alone would judge the machine and who else works on it.
namespace glenoid::test {

/// Seconds of processor time.
template <typename Work>
double secondsOf(Work&& work) {
  const std::clock_t start = std::clock();
  work();
  return static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
}

/// What this machine takes to sort four million numbers: 0.3 to 0.45 s where the bounds of our tests were found.
inline double sortingSeconds() {
  std::mt19937_64 random(1);
  std::vector<double> numbers(4000000);
  for (double& x : numbers) x = static_cast<double>(random());
  return secondsOf([&] { std::sort(numbers.begin(), numbers.end()); });
}

/// And to factor dense matrices of 192 rows, arithmetic like a step's, which a neighbour on the same core slows otherwise than
/// sorting: 0.3 s there.
inline double factoringSeconds() {
  const Eigen::MatrixXd half = Eigen::MatrixXd::Random(192, 192);
  const Eigen::MatrixXd whole = half * half.transpose() + Eigen::MatrixXd::Identity(192, 192);
  double sum = 0;
  const double seconds = secondsOf([&] {
    for (int i = 0; i < 1500; ++i) sum += whole.llt().matrixLLT()(i % 192, i % 192);
  });
  return sum == 0 ? 0 : seconds;  // so that the work is not left out
}

/// By how much slower than there it is now; at least 1.
inline double slowness() { return std::max({1.0, sortingSeconds() / 0.43, factoringSeconds() / 0.3}); }

/// The same around a piece of work, which may take long enough for the neighbours to change.
class SlownessAround {
 public:
  /// To be asked after the work.
  double worst() const { return std::max(m_before, slowness()); }

 private:
  double m_before = slowness();
};

}  // namespace glenoid::test
