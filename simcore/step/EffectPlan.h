// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/step/Model.h"

namespace glenoid {

/// What the effects of a scene could act on.
struct EffectGrounds {
  bool gravity = false, couplings = false, contact = false, selfContact = false, friction = false, damping = false, bursa = false, dent = false;
};

/// Wish and grounds to a plan. An effect that this version has not built is off, whatever was wished, and says so.
std::vector<EffectPlan> planEffects(const Effects& wish, const EffectGrounds& grounds);

}  // namespace glenoid
