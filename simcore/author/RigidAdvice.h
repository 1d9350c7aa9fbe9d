// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>

#include "simcore/scene/Part.h"

namespace glenoid {

/// What would keep two rigid parts apart whose collision surfaces cut each other. Cages cannot: they move soft parts.
struct RigidAdvice {
  bool surfacesOverlap = false;  ///< the visual surfaces do as well: no collision surface made of them can be free
  int triangles = 0;             ///< collision triangles of each with which they would be apart, tried; 0: no number tried will do
  double clearance = 0;          ///< m: a recipe's `clearance` with which these triangles would be apart, tried; 0: it does not help
  bool operator==(const RigidAdvice&) const = default;
};

/// Tries both remedies on the two parts alone, as buildJoint would of a recipe without a start (with one it works in the joint's own
/// frame, where the same number of triangles lies a little differently): up to sixteen times the triangles, and half of the room
/// between the visual surfaces. Both parts need their surfaces, closed. Takes as long as simplifying them a few times; `goOn` is
/// asked before each try and ends it when it says false: what is known by then is the answer. Deterministic.
RigidAdvice adviseRigid(const Part& a, const Part& b, const std::function<bool()>& goOn = {});

}  // namespace glenoid
