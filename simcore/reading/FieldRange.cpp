// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/reading/FieldRange.h"

#include <algorithm>
#include <cmath>

namespace glenoid {

namespace {

constexpr double kShare = 0.98;

/// The first of `mantissas` (ascending, 1 first) times a power of ten that is at least x > 0.
double roundUp(double x, std::span<const double> mantissas) {
  const double power = std::pow(10, std::floor(std::log10(x)));
  for (const double m : mantissas)
    if (m * power >= x * (1 - 1e-9)) return m * power;
  return 10 * power;
}

}  // namespace

double fieldReach(Quantity quantity, const SurfaceValues& values, std::span<const char> hidden) {
  std::vector<float> all;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (i < hidden.size() && hidden[i]) continue;
    for (const float value : values[i])
      if (std::isfinite(value) && (quantity != Quantity::Contact || value != 0)) all.push_back(std::abs(value));
  }
  if (all.empty()) return 0;
  const auto at = all.begin() + static_cast<std::ptrdiff_t>(kShare * static_cast<double>(all.size() - 1));
  std::nth_element(all.begin(), at, all.end());
  return *at;
}

FieldRange rangeFor(Quantity quantity, double reach) {
  constexpr double kEnds[] = {1, 1.5, 2, 3, 4, 5, 6, 8}, kStrain = 0.01, kPressure = 1e3;
  const double nothing = quantity == Quantity::Strain ? kStrain : kPressure;
  const double high = reach > 1e-12 * nothing ? roundUp(reach, kEnds) : nothing;
  return {quantity == Quantity::Pressure ? -high : 0, high};
}

const FieldRange& SteadyRange::follow(Quantity quantity, double reach) {
  const bool stays = m_range && m_quantity == quantity && reach <= 1.1 * m_range->high && reach >= 0.5 * m_range->high;
  if (!stays) m_range = rangeFor(quantity, reach);
  m_quantity = quantity;
  return *m_range;
}

std::vector<double> ticksIn(const FieldRange& range, int most) {
  constexpr double kSteps[] = {1, 2, 2.5, 5};
  constexpr double kMore[] = {1, 4};
  std::vector<double> ticks;
  if (!(range.high > range.low) || most < 1 || !std::isfinite(range.high - range.low)) return ticks;
  const double span = range.high - range.low, least = roundUp(span / most, kSteps);
  const auto endsOn = [&](double step) {
    const auto whole = [step](double x) { return std::abs(x / step - std::round(x / step)) < 1e-9; };
    return whole(range.low) && whole(range.high);
  };
  double step = 0;
  for (const std::span<const double> steps : {std::span<const double>(kSteps), std::span<const double>(kMore)})
    for (double next = roundUp(span / most, steps); step == 0 && next <= span / 2; next = roundUp(1.001 * next, steps))
      if (endsOn(next)) step = next;
  if (step == 0) step = least;
  const double slack = 1e-9 * step;
  for (double n = std::ceil((range.low - slack) / step); n * step <= range.high + slack; ++n) ticks.push_back(n == 0 ? 0 : n * step);
  return ticks;
}

}  // namespace glenoid
