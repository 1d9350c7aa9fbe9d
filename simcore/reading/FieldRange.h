// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <span>
#include <vector>

#include "simcore/reading/SurfaceField.h"

namespace glenoid {

/// Ends of a scale, in the quantity's unit; low < high.
struct FieldRange {
  double low = 0, high = 1;
  bool operator==(const FieldRange&) const = default;
};

/// How far values go: what 98 % of those that are shown stay within, by magnitude; of contact, of those that are not zero. Single
/// vertices (a clamp's edge, a sliver) do not stretch it. Zero where nothing is shown or all is zero. `hidden`: by object,
/// not 0: left out; empty: none is.
double fieldReach(Quantity quantity, const SurfaceValues& values, std::span<const char> hidden = {});

/// The scale for a reach: from zero (of pressure, which has a sign, from as far below) to the first of 1, 1.5, 2, 3, 4, 5, 6, 8
/// times a power of ten that is at least the reach. Without any reach 1 kPa, of strain 1 %.
FieldRange rangeFor(Quantity quantity, double reach);

/// An automatic scale that stays while values move a little: another one is taken when the reach leaves [0.5, 1.1] of its end.
class SteadyRange {
 public:
  const FieldRange& follow(Quantity quantity, double reach);
  void forget() { m_range.reset(); }

 private:
  std::optional<FieldRange> m_range;
  Quantity m_quantity = Quantity::Stress;
};

/// Round values within a range, ascending, at most `most` + 1: steps of 1, 2, 2.5, 4 or 5 times a power of ten. Both ends are
/// among them where a step allows it, as with the ends of rangeFor.
std::vector<double> ticksIn(const FieldRange& range, int most = 6);

}  // namespace glenoid
