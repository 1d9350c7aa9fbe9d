// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/step/Model.h"

namespace glenoid {

/// Shapes that no tissue ever has, in which a soft part may begin all the same: after a bad edit, a bad file, or worse.
enum class Misshape {
  Scattered,         ///< every node anywhere in the part's box
  CollapsedToPlane,  ///< every node in the middle plane across the box's shortest side
  CollapsedToPoint,  ///< every node at one point, beside the middle
  Mirrored,          ///< across that plane
  InsideOut,         ///< through the middle
  Squeezed           ///< to a tenth along the box's shortest side
};

/// Moves the nodes of a soft object that moves, from where they are in `state`; they keep their velocities. `seed` decides where
/// nodes are scattered to. The same bits on every machine.
void misshape(const Model& model, int object, Misshape how, unsigned seed, State& state);

}  // namespace glenoid
