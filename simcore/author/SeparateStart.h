// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "simcore/author/Overlaps.h"
#include "simcore/base/Error.h"
#include "simcore/scene/Joint.h"
#include "simcore/scene/Recipe.h"

namespace glenoid {

/// What came of it.
struct SeparationOutcome {
  int overlapsBefore = 0;
  double depthBefore = 0;     ///< m, the deepest
  int sweeps = 0;
  double maxShift = 0;        ///< m, greatest displacement of a collision vertex
  std::vector<std::string> movedParts;
  std::vector<double> shifts;  ///< m, greatest of a collision vertex, of each of movedParts
  StartCheck check;           ///< of the start afterwards
};

/// Sweeps done of all that may be needed, 0…1, and how many pairs still overlap. False stops.
using SeparationProgress = std::function<bool(double done, int overlaps)>;

/// Moves the cages of soft parts until no two surfaces of parts that may collide cut each other: at each sweep every
/// part takes the handle positions of least elastic energy at which its surface keeps the clearance to the others as
/// they stand (against another soft part each does half). Cages are made for parts that need one and have none; those
/// that end where they began are left out again. Sets joint.cages and joint.startProof, which also tells when it did
/// not succeed; rigid parts stay where they are. Deterministic. Fails with OutOfRange for a clearance that is not
/// positive, with UnknownId, as makeCage does, or with Cancelled (the joint is then as it was).
Result<SeparationOutcome> separateStart(Joint& joint, const StartWishes& wishes, const SeparationProgress& progress = {});

}  // namespace glenoid
