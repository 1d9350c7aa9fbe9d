// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <span>

#include "simcore/mesh/TriMesh.h"

namespace glenoid {

/// Cuts a polygon of at least three corners into triangles of the same winding: ear clipping in the plane of its mean
/// normal (Newell), best-shaped ear first; concave ones come out right, those that cut themselves somehow. n corners
/// always give n − 2 triangles. Polygons of more than a thousand corners are cut as a fan.
void splitPolygon(const std::vector<Vec3>& points, std::span<const int> corners,
                  std::vector<std::array<int, 3>>& triangles);

}  // namespace glenoid
