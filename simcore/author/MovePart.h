// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/base/Error.h"
#include "simcore/scene/Part.h"

namespace glenoid {

/// How an author puts a part elsewhere after its import: turned about X, then Y, then Z of W through the middle of its box, scaled
/// from there, then shifted.
struct PartMove {
  Vec3 turn_deg = Vec3::Zero();
  double scale = 1;              ///< > 0
  Vec3 shift_W = Vec3::Zero();   ///< m
  bool operator==(const PartMove&) const = default;
};

/// The part at its new place: surfaces and landmarks, its tetrahedra too; one that runs as cells is cut into cells anew, which
/// stand along the joint's axes. Regions hold, dents are no longer known. Fails with OutOfRange (a scale that is not positive, a
/// number that is none) and as embedAlong does.
Result<Part> movedPart(const Part& part, const PartMove& move);

}  // namespace glenoid
