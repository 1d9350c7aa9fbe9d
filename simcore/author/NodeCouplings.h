// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/base/Error.h"
#include "simcore/scene/Recipe.h"

namespace glenoid {

/// Adds the coupling with the nodes that it is meant to hold at, ascending; the joint's cells must be cut. Fails with UnknownId for a part
/// that is not there, NothingNear where nothing lies within the distance and the ball, or a point has no node near
/// (argument: what), BadNodes where A is rigid or what is found cannot hold. The place names the coupling.
Result<Done> addNodeCoupling(Joint& joint, const NodeCoupling& wish);

}  // namespace glenoid
