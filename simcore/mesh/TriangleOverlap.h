// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>

#include "simcore/base/Math.h"
#include "simcore/mesh/TriMesh.h"

namespace glenoid {

using Triangle3 = std::array<Vec3, 3>;

/// Whether two triangles share more than `tolerance` (m) of depth along every separating direction: crossing
/// or lying on each other counts, touching does not. Separating axes: both normals, nine edge products
/// and, for triangles in one plane, the edges' normals in it.
/// Source: Gottschalk, Lin, Manocha, "OBBTree", SIGGRAPH 1996 (separating axis theorem).
bool trianglesOverlap(const Triangle3& a, const Triangle3& b, double tolerance);

/// Whether the segment p–q passes through the triangle's inside, its ends more than `tolerance` (m) off the
/// plane.
bool segmentPierces(const Vec3& p, const Vec3& q, const Triangle3& t, double tolerance);

/// Whether two triangles with the common corner a[0] = b[0] cut each other away from it: the far edge of one
/// pierces the other.
bool fansCross(const Triangle3& a, const Triangle3& b, double tolerance);

/// Whether two triangles of a mesh cut each other: apart, they overlap; with one common vertex, they cross
/// away from it; with a common edge never.
bool trianglesCut(const TriMesh& mesh, int a, int b, double tolerance);

}  // namespace glenoid
