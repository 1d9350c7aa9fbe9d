// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/live/Notice.h"
#include "simcore/step/Stepper.h"

namespace glenoid {

/// Where a run stood when its time was up: the pair with most contacts, and how many there were of all pairs. `limit`: s of the
/// clock.
Notice timeUp(const Model& model, const StepReport& step, const State& state, double limit);

}  // namespace glenoid
