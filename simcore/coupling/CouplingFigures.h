// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/base/Error.h"
#include "simcore/scene/Joint.h"

namespace glenoid {

/// What an author wants to know of a coupling before it is run; all at rest.
struct CouplingFigures {
  int springs = 0;
  double area = 0;       ///< of what it holds of part A's surface (heldSurface), m²; may be 0 at nodes
  double coverage = 0;   ///< share of part A's surface that this is, 0…1
  double stiffness = 0;  ///< of all springs together, N/m
  /// How far the region's triangle centres, or the nodes, lie off part B's visual surface, m; 0 inside it. The springs
  /// themselves have no length at rest: each end takes the other's place, and what stands off moves with B as
  /// if glued to it.
  double meanGap = 0, maxGap = 0;
  std::vector<Vec3> anchors_W;  ///< where the springs hold, m
  int island = -1;              ///< coupling island of the joint, −1 where both parts are fixed
};

/// Fails as deriveSprings does, and with Unusable for a soft part without tetrahedra. `fixedParts`: ids of
/// parts that a scenario moves; they join no island.
Result<CouplingFigures> couplingFigures(const Joint& joint, int coupling,
                                        const std::vector<std::string>& fixedParts = {});

/// Coupling island of each part, −1: fixed.
std::vector<int> islandsOfParts(const Joint& joint, const std::vector<std::string>& fixedParts);

/// A stiffness for each node to begin with, N/m: the one below over the face of a cell of part A.
double suggestedNodeStiffness(const Joint& joint, const std::string& partA, const std::string& partB);

/// A stiffness per area to begin with, N/m per m²: Young's modulus of the softer tissue over the thickness
/// that the bond stands for, which is a cell of the soft part (the finer of two), or 5 mm between rigid
/// parts. So the bond is about as stiff as the layer of tissue it replaces. Falls back to 50 kPa where no
/// material is known.
double suggestedStiffness(const Joint& joint, const std::string& partA, const std::string& partB);

}  // namespace glenoid
