// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "simcore/base/Error.h"
#include "simcore/scene/Joint.h"

namespace glenoid {

/// What became of the picked nodes of a part that got other cells.
struct CarriedNodes {
  int couplings = 0;    ///< at nodes of the part
  int picked = 0;       ///< nodes of all of them before
  int now = 0;          ///< and after: fewer where two became one
  double farthest = 0;  ///< m from an old node to its new one
};

/// Gives couplings at nodes of a part new numbers after its cells were made anew (`joint` has them already): each old
/// node becomes the nearest one of the new cells, within half the diagonal of a cell, the larger of both. Where two
/// become one, the springs get as much stiffer as keeps their sum. Nothing is changed where the mesh is the same, or on failure:
/// BadNodes where a node finds none, or what is left is no longer enough to hold; the place names the coupling.
/// `before`: the mesh that the numbers speak of; `cellBefore`: its cells' edge, m.
Result<CarriedNodes> carryNodes(Joint& joint, const std::string& part, const TetMesh& before, double cellBefore);

}  // namespace glenoid
