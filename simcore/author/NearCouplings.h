// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/base/Error.h"
#include "simcore/scene/Recipe.h"

namespace glenoid {

/// Adds the coupling and, on part A, the region it is over, named by the coupling's id ("footprint"). Fails with
/// UnknownId for a part that is not there, DuplicateId when part A has such a region, TooFewSprings when what lies
/// within the distance cannot hold (see canHold). The place names the coupling.
Result<Done> addNearCoupling(Joint& joint, const NearCoupling& near);

}  // namespace glenoid
