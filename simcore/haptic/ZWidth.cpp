// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/haptic/ZWidth.h"

#include <Eigen/Eigenvalues>
#include <cmath>
#include <functional>

#include "simcore/base/Math.h"
#include "simcore/haptic/DeviceProfile.h"

namespace glenoid {

namespace {

/// The edge of a range of K that begins at 0, where `good` holds.
double edge(const std::function<bool(double)>& good) {
  if (!good(0)) return 0;
  double low = 0, high = 1;
  while (good(high) && high < 1e9) low = high, high *= 2;
  while (high - low > 1e-6 * high) (good(0.5 * (low + high)) ? low : high) = 0.5 * (low + high);
  return low;
}

}  // namespace

double wallGrowth(const WallDevice& device, double K, double B) {
  const double T = device.period, b = device.damping, decay = std::exp(-b * T / device.mass);
  const double glide = device.mass / b * (1 - decay), gain = (1 - decay) / b, shift = (T - glide) / b;
  // z = (x, v, x before, forces on their way, newest first).
  const int n = device.delayTicks;
  MatX tick = MatX::Zero(3 + n, 3 + n);
  Eigen::RowVectorXd answer = Eigen::RowVectorXd::Zero(3 + n), held = answer;
  answer[0] = -K - B / T;
  answer[2] = B / T;
  if (n == 0) held = answer;
  else held[2 + n] = 1;
  tick(0, 0) = 1;
  tick(0, 1) = glide;
  tick.row(0) += shift * held;
  tick(1, 1) = decay;
  tick.row(1) += gain * held;
  tick(2, 0) = 1;
  if (n > 0) tick.row(3) = answer;
  for (int i = 1; i < n; ++i) tick(3 + i, 2 + i) = 1;
  return Eigen::EigenSolver<MatX>(tick, false).eigenvalues().cwiseAbs().maxCoeff();
}

double stiffestStable(const WallDevice& device, double damping) {
  // Without a spring the place is free, and its eigenvalue is 1; round-off of that is no swing.
  return edge([&](double K) { return wallGrowth(device, K, damping) <= 1 + 1e-9; });
}

double stiffestPassive(const WallDevice& device, double damping) {
  const double delay = device.delayTicks * device.period;
  return edge([&](double K) { return dampingNeeded(K, damping, device.period, delay) <= device.damping; });
}

}  // namespace glenoid
