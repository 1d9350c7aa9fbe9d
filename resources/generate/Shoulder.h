// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/author/BuildJoint.h"

/// The shoulder that ships: eleven parts as in Table 1 of Otaduy, Garre, Gascón, Miguel, Pérez, Zurdo,
/// "Modeling and Simulation of a Human Shoulder for Interactive Medical Applications", CEIG 2010, with
/// surfaces of our own.
namespace glenoid::generate {

/// Surfaces, regions, materials, couplings and exclusions; metres. Deterministic; the first call takes
/// some forty seconds, a later one gives a copy.
JointRecipe shoulderRecipe();

/// The recipe carried through the author's pipeline (separation, cells). Fails as buildJoint does.
Result<Joint> makeShoulder();

/// The same with clavicle, deltoid, skin and fat, for palpation.
JointRecipe palpationRecipe();
Result<Joint> makePalpation();

/// The same with capsule, glenohumeral ligaments, teres minor and portals, for arthroscopy.
JointRecipe capsuleRecipe();
Result<Joint> makeWithCapsule();

/// Millimetres to metres.
std::shared_ptr<const TriMesh> inMetres(TriMesh mesh);
/// A coupling of a wanted total stiffness, N/m; stated per area with three figures.
Coupling bond(const JointRecipe& recipe, const char* a, const char* region, const char* b, double total);

}  // namespace glenoid::generate
