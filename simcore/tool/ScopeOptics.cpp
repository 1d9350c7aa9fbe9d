// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/tool/ScopeOptics.h"

#include <algorithm>

#include "simcore/base/PlainMath.h"

namespace glenoid {

ScopeAxes scopeAxes(const Tool& tool) {
  const Vec3 aside(plain::cosine(tool.lensTurn), plain::sine(tool.lensTurn), 0);  // where the lens is turned to
  const double c = plain::cosine(tool.lens), s = plain::sine(tool.lens);
  // The turn that takes −Z to forward leaves what is across both; of +X the share along aside goes to c aside + s Z.
  const double along = aside.x();
  return {s * aside - c * Vec3::UnitZ(), Vec3::UnitX() + along * ((c - 1) * aside + s * Vec3::UnitZ())};
}

double halfFieldOf(const Tool& tool) {
  constexpr double kWater = 1.333, kWidest = 1.5;
  const double half = tool.fieldOfView / 2;
  if (!tool.inAir) return half;
  const double sine = kWater * plain::sine(half);
  return sine < 1 ? std::min(plain::arcSine(sine), kWidest) : kWidest;
}

}  // namespace glenoid
