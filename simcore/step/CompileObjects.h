// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>

#include "simcore/coupling/Springs.h"
#include "simcore/step/StepModel.h"

namespace glenoid {

/// Parts and tools as contact objects, with their surfaces bound and their place in the state; fills
/// model.objects, model.start and inside.objects. `centres`: body frame origin of each rigid object at rest.
Result<Done> compileObjects(Model& model, StepModel& inside, std::vector<Vec3>& centres);

/// Coulomb's coefficient at each collision vertex of every object; after compileContacts. False where no pair that
/// may collide is rough on both sides.
bool compileFriction(Model& model);

/// Pairs that may collide and the triangles they leave out; fills model.collisionSurfaces and collisionPairs.
/// Left out are: exclusions of the joint, two fixed objects, a tool and what it perforates, and, between two
/// coupled parts, the triangles within 3 mm of the region that couples them. Last come the parts that may fold onto
/// themselves.
void compileContacts(Model& model);

/// The joint's bursae on the collision surfaces; after compileContacts. One whose sides have nothing is left out.
std::vector<FilmModel> compileFilms(const Model& model);

/// What each object gives under a round tool beyond its own elements; empty where no part has such a table that still
/// holds, or the scene no such tool.
std::vector<DentModel> compileDents(const Model& model);
/// The rest of it: how the objects' own elements answer, and the tools; once couplings have their springs.
void bindDents(const Model& model, StepModel& inside);

}  // namespace glenoid
