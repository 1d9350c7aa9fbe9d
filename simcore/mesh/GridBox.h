// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/mesh/TriMesh.h"

namespace glenoid {

/// Closed box, wound outwards: each face a grid of so many cells along x, y and z (at least one), each cell two triangles.
TriMesh gridBox(const Vec3& low, const Vec3& high, const std::array<int, 3>& cells);

}  // namespace glenoid
