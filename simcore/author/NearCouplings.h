// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <span>

#include "simcore/base/Error.h"
#include "simcore/scene/Recipe.h"

namespace glenoid {

/// Asks, before anything is built, whether each coupling finds surface of its part A within its distance of part B (and in its
/// ball and its region). Fails with NothingNear, which names all that do not and how far apart their parts are (argument: what), with UnknownId
/// for a part that is not there.
Result<Done> checkNearCouplings(std::span<const PartRecipe> parts, std::span<const NearCoupling> couplings);

/// Adds the coupling and, on part A, the region it is over, named by the coupling's id ("footprint"). Fails with
/// UnknownId for a part that is not there, DuplicateId when part A has such a region, NothingNear as above, TooFewSprings when
/// what lies within the distance cannot hold (see canHold). The place names the coupling.
Result<Done> addNearCoupling(Joint& joint, const NearCoupling& near);

}  // namespace glenoid
