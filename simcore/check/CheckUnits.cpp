// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "simcore/check/CheckParts.h"

namespace glenoid::check {
namespace {

// A human bone or ligament is between some millimetres and half a metre long. Beyond these something else was meant.
constexpr double kSmallest = 1e-3, kLargest = 3.0;    // m
constexpr double kUsualLow = 0.02, kUsualHigh = 1.0;  // m, of what a corrected unit should give

/// Factor to metres that makes an extent usual: millimetres, centimetres, inches, or the other way round.
double factorFor(double extent, double low) {
  constexpr double kLarge[] = {1e-3, 1e-2, 0.0254, 1e-6}, kSmall[] = {1e3, 1e2, 1e6};
  const auto fits = [&](double factor) { return extent * factor >= low && extent * factor <= kUsualHigh; };
  if (extent > kLargest) {
    for (const double factor : kLarge)
      if (fits(factor)) return factor;
    return 1e-3;
  }
  for (const double factor : kSmall)
    if (fits(factor)) return factor;
  return 1e3;
}

}  // namespace

void checkUnits(Work& work) {
  const Joint& joint = work.joint;
  std::vector<double> extents(joint.parts.size(), 0);
  double largest = 0;
  int large = 0, small = 0, seen = 0;
  for (std::size_t i = 0; i < joint.parts.size(); ++i) {
    if (!work.surfaces[i]) continue;
    extents[i] = boundsOf(*joint.parts[i].visual).sizes().maxCoeff();
    largest = std::max(largest, extents[i]);
    large += extents[i] > kLargest;
    small += extents[i] < kSmallest;
    ++seen;
  }
  if (seen == 0 || large + small == 0) return;
  if (large == seen || small == seen) {
    Problem& problem = work.add(ProblemKind::UnitOfJoint, Severity::Warning);
    problem.figure = largest;
    problem.wanted = factorFor(largest, kUsualLow);
    return;
  }
  for (std::size_t i = 0; i < joint.parts.size(); ++i) {
    if (!work.surfaces[i] || (extents[i] <= kLargest && extents[i] >= kSmallest)) continue;
    Problem& problem = work.add(ProblemKind::UnitOfPart, Severity::Warning, joint.parts[i].id);
    problem.figure = extents[i];
    problem.wanted = factorFor(extents[i], 5e-3);
  }
}

}  // namespace glenoid::check
