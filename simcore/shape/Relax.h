// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/shape/Field.h"
#include "simcore/mesh/Isosurface.h"

namespace glenoid::shape {

/// Evens out the triangles: moves each vertex toward the mean of its neighbours, then back to the field's
/// surface.
void relax(TriMesh& mesh, const Field& field, int rounds);

}  // namespace glenoid::shape
