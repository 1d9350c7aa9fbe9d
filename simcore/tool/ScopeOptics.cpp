// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/tool/ScopeOptics.h"

#include <algorithm>
#include <cmath>

namespace glenoid {

ScopeAxes scopeAxes(const Tool& tool) {
  const Vec3 aside(std::cos(tool.lensTurn), std::sin(tool.lensTurn), 0);  // where the lens is turned to
  const Vec3 hinge(-aside.y(), aside.x(), 0);                             // −Z × aside, turned so that −Z goes to aside
  const Mat3 turn = Eigen::AngleAxisd(-tool.lens, hinge).toRotationMatrix();
  return {turn * -Vec3::UnitZ(), turn * Vec3::UnitX()};
}

double halfFieldOf(const Tool& tool) {
  constexpr double kWater = 1.333, kWidest = 1.5;
  const double half = tool.fieldOfView / 2;
  if (!tool.inAir) return half;
  const double sine = kWater * std::sin(half);
  return sine < 1 ? std::min(std::asin(sine), kWidest) : kWidest;
}

}  // namespace glenoid
