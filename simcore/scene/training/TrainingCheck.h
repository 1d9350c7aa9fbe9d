// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/base/Error.h"
#include "simcore/scene/Joint.h"
#include "simcore/scene/Scenario.h"

namespace glenoid {

/// What the schema cannot say of a scenario's training by itself: ids that occur once, places that are one thing, forces that
/// leave a band, keys that ascend, tools that are there. Fails with DuplicateId, UnknownId or Unusable; the place names the file and
/// the pointer.
Result<Done> checkTraining(const Scenario& scenario, const std::string& file);

/// What its places and limits refer to. Fails with UnknownId.
Result<Done> checkTraining(const Scenario& scenario, const Joint& joint, const Place& place);

/// Takes out the places and limits that refer to what the joint does not have, and tasks that have too few places left.
void keepTrainingTo(const Joint& joint, Training& training);

}  // namespace glenoid
