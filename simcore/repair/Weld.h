// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/mesh/TriMesh.h"

namespace glenoid {

/// Repairs of single points and faces. Each takes a readable mesh, keeps the order of what stays, and says how many
/// points or faces it changed.

/// For each vertex the first of those within `tolerance` of it (chains count as one); itself where it stands alone.
std::vector<int> nearestRepresentatives(const TriMesh& mesh, double tolerance);

/// A repeated corner, or a height below `flat`.
bool isDegenerate(const TriMesh& mesh, int triangle, double flat);

/// Faces with the same three corners as an earlier one, whichever way they are wound, ascending.
std::vector<int> duplicateFaces(const TriMesh& mesh);

/// Vertices within `tolerance` become one; faces that lose a corner go.
TriMesh welded(const TriMesh& mesh, double tolerance, long& changed);

/// No faces without area, and no unused vertices: short sides are drawn together, a flat face whose corner lies on the
/// opposite side gives that corner to its neighbour, so that no crack opens. `left`: those that could not be helped.
TriMesh withoutDegenerate(const TriMesh& mesh, long& changed, long& left);

/// One of each set of faces with the same corners. A patch of faces back to back whose whole border hangs on other faces, a fin,
/// goes; a surface that has two such sides keeps one.
TriMesh withoutDuplicates(const TriMesh& mesh, long& changed);

/// Some triangles of a mesh, with the vertices they need.
TriMesh withTriangles(const TriMesh& mesh, const std::vector<char>& keep);

}  // namespace glenoid
