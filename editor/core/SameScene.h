// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "editor/core/ChangeSet.h"
#include "editor/core/Document.h"

namespace glenoid {

/// Whether two values are what the same author would call the same. Meshes are compared by identity, since they never
/// change and every copy of a scene shares them: this costs nothing however many triangles they have.
bool sameMeshes(const Part& a, const Part& b);
bool samePart(const Part& a, const Part& b);
bool sameJoint(const Joint& a, const Joint& b);

/// What differs, by id, for the views; `model` when it differs in anything that is computed.
ChangeSet changesBetween(const Joint& before, const Joint& after);

}  // namespace glenoid
