// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/base/Error.h"
#include "simcore/body/State.h"
#include "simcore/author/BuildJoint.h"
#include "simcore/step/Model.h"

namespace glenoid {

/// The same joint in finer cells: every soft part has about `factor` times as many tetrahedra, every collision
/// surface about factor^(2/3) times as many triangles, so that contacts grow with the surface. Visual surfaces,
/// regions, materials and couplings stay; picked nodes of couplings become the nearest new ones (coupling/CarryNodes.h). Collision surfaces are simplified anew from the visual ones (cut in four
/// first where those are too coarse) and kept `clearance` (m) apart; cells lie along each part's principal axes.
/// `factor` ≥ 1; 1 gives the joint back as it is. Takes seconds for 10 and up to a minute for 100. Deterministic.
/// Fails as buildJoint does, with OutOfRange for a factor below 1, with Unusable for a region on a collision
/// surface, whose triangles would be lost, with BadNodes where a picked node of a coupling has no new node near.
Result<Joint> refineJoint(const Joint& joint, double factor, double clearance = 0.4e-3,
                          const BuildProgress& progress = {});

/// The same with the cells of soft parts alone: collision surfaces, and with them where parts touch, stay as they are. Fails with OutOfRange
/// for a factor below 1 and as buildJoint does where no cells of such a size hold a part together. Takes seconds.
Result<Joint> refineCells(const Joint& joint, double factor, const BuildProgress& progress = {});

/// A state of one model for another of the same parts and tools in finer cells: rigid objects keep pose and
/// velocity, the nodes of a soft one go where the coarse tetrahedra carry them. Impulses start from nothing.
/// Both models must hold the same objects in the same order (assert).
State carryToRefined(const Model& coarse, const State& state, const Model& fine);

}  // namespace glenoid
