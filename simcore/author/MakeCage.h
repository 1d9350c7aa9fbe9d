// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/base/Error.h"
#include "simcore/scene/Joint.h"

namespace glenoid {

/// A cage around a soft part with about `handles` vertices: the level set of the distance to its tetrahedra, far
/// enough out that all nodes lie inside, simplified to a closed manifold. Nothing is moved yet. Its id is the part's
/// with "-cage" behind. Deterministic. Fails with Unusable for a part without volume and with OutOfRange for fewer than
/// 8 or more than 2000 handles.
Result<Cage> makeCage(const Part& part, int handles = 80);

/// The joint with this cage in the place of the one its part had, or behind all others; drops the proof of the start.
void putCage(Joint& joint, Cage cage);

}  // namespace glenoid
