// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "resources/generate/Field.h"
#include "simcore/mesh/TriMesh.h"

/// From an implicit shape to a closed triangle surface, millimetres.
namespace glenoid::generate {

/// Closed, outward wound surface of field = 0 inside the box, by marching the six tetrahedra of each grid
/// cell (so it is manifold without exception), grid step `h`. The surface must not cross the box. Vertices
/// are merged by grid edge, ordered by first use: same field, same mesh. Regular but with slivers: relax
/// afterwards. Source of the six-tetrahedra split: Kuhn's triangulation of the cube.
TriMesh isosurface(const Field& field, const Box3& box, double h);

/// For each vertex the mean of its neighbours on a closed surface; itself where it has none.
std::vector<Vec3> neighbourMeans(const TriMesh& mesh);

/// Evens out the triangles: moves each vertex toward the mean of its neighbours, then back to the field's
/// surface.
void relax(TriMesh& mesh, const Field& field, int rounds);

/// Removes components other than the one with most triangles, and unused vertices.
TriMesh largestComponent(const TriMesh& mesh);

}  // namespace glenoid::generate
