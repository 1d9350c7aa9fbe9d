// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/scene/SceneScale.h"

#include <algorithm>
#include <vector>

namespace glenoid {

namespace {

constexpr double kContactShare = 0.02;   // of the median extent
constexpr double kUsualExtent = 0.075;   // m
constexpr double kRecoveryTime = 0.015;  // s for one contact distance

double medianExtent(const Joint& joint, const std::vector<std::string>& fixed) {
  std::vector<double> extents;
  for (const Part& part : joint.parts) {
    if (std::find(fixed.begin(), fixed.end(), part.id) != fixed.end() || !part.visual || part.visual->vertices.empty()) continue;
    const double extent = boundsOf(*part.visual).sizes().maxCoeff();
    if (extent > 0) extents.push_back(extent);
  }
  if (extents.empty()) return kUsualExtent;
  const auto middle = extents.begin() + static_cast<std::ptrdiff_t>(extents.size() / 2);
  std::nth_element(extents.begin(), middle, extents.end());
  return *middle;
}

}  // namespace

Scenario scaled(const Joint& joint, Scenario scenario) {
  if (!(scenario.contactDistance > 0)) scenario.contactDistance = kContactShare * medianExtent(joint, scenario.fixedParts);
  if (!(scenario.recoverySpeedMax > 0)) scenario.recoverySpeedMax = scenario.contactDistance / kRecoveryTime;
  return scenario;
}

}  // namespace glenoid
