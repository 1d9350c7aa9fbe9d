// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>

#include "simcore/base/Math.h"

namespace glenoid {

/// Whether a triangle reaches more than `tolerance` (m) deep into a tetrahedron: separating axes are the
/// triangle's normal, the four faces' normals and the products of edges. Touching is not reaching.
/// Internal to the cells.
bool triangleReachesInto(const std::array<Vec3, 3>& triangle, const std::array<Vec3, 4>& tet,
                         double tolerance);

}  // namespace glenoid
