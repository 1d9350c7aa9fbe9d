// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/train/Trail.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace glenoid {

double pathLength(std::span<const Vec3> trail) {
  double length = 0;
  for (std::size_t i = 1; i < trail.size(); ++i) length += (trail[i] - trail[i - 1]).norm();
  return length;
}

std::vector<Vec3> filteredTrail(std::span<const Vec3> trail, double dt) {
  const double sigma = std::sqrt(std::numbers::ln2) / (2 * std::numbers::pi * kTrailCutOff);
  const int reach = static_cast<int>(std::floor(4 * sigma / dt)), count = static_cast<int>(trail.size()) - 2 * reach;
  std::vector<double> weights;
  double all = 0;
  for (int k = -reach; k <= reach; ++k) {
    const double x = k * dt / sigma;
    weights.push_back(std::exp(-0.5 * x * x));
    all += weights.back();
  }
  std::vector<Vec3> smooth(static_cast<std::size_t>(std::max(0, count)), Vec3::Zero());
  for (std::size_t i = 0; i < smooth.size(); ++i)
    for (std::size_t k = 0; k < weights.size(); ++k) smooth[i] += weights[k] / all * trail[i + k];
  return smooth;
}

std::optional<double> logJerk(std::span<const Vec3> trail, double dt) {
  const std::vector<Vec3> x = filteredTrail(trail, dt);
  if (x.size() < 5) return std::nullopt;
  double squared = 0;
  const std::size_t last = x.size() - 2;
  for (std::size_t i = 2; i < last; ++i) squared += (x[i + 2] - 2 * x[i + 1] + 2 * x[i - 1] - x[i - 2]).squaredNorm();
  squared *= dt / (4 * std::pow(dt, 6));
  const double length = pathLength(std::span<const Vec3>(x).subspan(2, last - 2)), time = static_cast<double>(last - 3) * dt;
  if (length < 1e-3 || !(time > 0) || !(squared > 0)) return std::nullopt;
  return std::log(squared * std::pow(time, 5) / (length * length));
}

}  // namespace glenoid
