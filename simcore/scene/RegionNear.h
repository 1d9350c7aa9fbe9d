// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <span>
#include <vector>

#include "simcore/mesh/TriMesh.h"

namespace glenoid {

class TriangleTree;

/// Triangles of `surface` whose centre lies within `distance` (m, ≥ 0) of the surface `other` or inside it,
/// ascending: what an author means by "bind what is within d millimetres". Both in one frame at rest. An
/// `other` that is not closed has no inside that could be told, so it should be closed; an empty one is near
/// to nothing.
std::vector<int> trianglesNear(const TriMesh& surface, const TriMesh& other, double distance);

/// The same with the tree of the other surface at hand, for asking again and again with another distance.
std::vector<int> trianglesNear(const TriMesh& surface, const TriangleTree& other, double distance);

/// The same of points: which of them are near or inside, ascending.
std::vector<int> pointsNear(std::span<const Vec3> points_W, const TriangleTree& other, double distance);

}  // namespace glenoid
