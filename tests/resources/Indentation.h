// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "simcore/author/StaticPart.h"
#include "simcore/scene/Scenario.h"

namespace glenoid::test {

/// Where a tissue is pressed: the point of the surface nearest to the middle of a region, or of what lies in none of
/// the regions named with a minus.
struct PressedTissue {
  std::string part;
  std::string region;  ///< "tendon", "-tendon,origin,insertion", "" for the whole surface
};

Vec3 middleOf(const Part& part, const std::string& region);

/// How far a ball of the patch's radius goes into the part alone under 2 N: a fine static solve under an even pressure on its contact
/// with radius a = ∛(3 f R / 4 E*), and what Hertz' ball goes deeper into a half-space than that pressure. `refined`: in cells that are
/// finer by a factor 1.4 everywhere. m.
double fineIndentation(const Joint& joint, const std::string& part, const TipPatch& patch, bool refined);

/// How far the tip of a ball of the patch's radius goes from its first touch until the running simulation answers with
/// 2 N, pressed along the patch's normal. Every other part is fixed and without contact, as the static solve has it.
struct Pressed {
  double travel = 0;     ///< m
  double force = 0;      ///< N, at the end
  double drift = 0;      ///< m, sideways
  double dent = 0;       ///< m, the deepest that the step reports at the end
  bool settled = false;  ///< force within 1 % and at rest
};
Pressed pressWithTip(const Joint& joint, const std::string& part, const TipPatch& patch, Wish dent);

}  // namespace glenoid::test
