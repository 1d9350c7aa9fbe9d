// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/scene/BuildJoint.h"

/// The shoulder that ships: eleven parts as in Table 1 of Otaduy, Garre, Gascón, Miguel, Pérez, Zurdo,
/// "Modeling and Simulation of a Human Shoulder for Interactive Medical Applications", CEIG 2010, with
/// surfaces of our own.
namespace glenoid::generate {

/// Surfaces, regions, materials, couplings and exclusions; metres. Deterministic; takes some ten seconds.
JointRecipe shoulderRecipe();

/// The recipe carried through the author's pipeline (separation, cells). Fails as buildJoint does.
Result<Joint> makeShoulder();

}  // namespace glenoid::generate
