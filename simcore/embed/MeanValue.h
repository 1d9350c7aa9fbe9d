// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/mesh/TriMesh.h"

namespace glenoid {

/// Mean value coordinates of a point in a closed triangle surface, one for each vertex; they sum to one and
/// reproduce linear fields. Smooth everywhere, also outside; on the surface they are the barycentric coordinates
/// of its triangle. Where the surface is concave as seen from the point, some may be negative. The surface must be
/// wound outwards, with indices in range.
/// Source: Ju, Schaefer and Warren, "Mean Value Coordinates for Closed Triangular Meshes", SIGGRAPH 2005, with the
/// case of a point in a triangle's plane as their section 3.1 says.
VecX meanValueCoordinates(const TriMesh& surface, const Vec3& p);

}  // namespace glenoid
