// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <vector>

#include "simcore/mesh/TriMesh.h"

namespace glenoid {

/// An implicit shape: negative inside, positive outside. Any unit of length.
using ScalarField = std::function<double(const Vec3&)>;

/// Closed, outward wound surface of field = 0 inside the box, by marching the six tetrahedra of each grid
/// cell (so it is manifold without exception), grid step `h`. The surface must not cross the box. Vertices
/// are merged by grid edge, ordered by first use: same field, same mesh. Regular but with slivers: relax
/// afterwards. Source of the six-tetrahedra split: Kuhn's triangulation of the cube.
TriMesh isosurface(const ScalarField& field, const Box3& box, double h);

/// For each vertex the mean of its neighbours on a closed surface; itself where it has none.
std::vector<Vec3> neighbourMeans(const TriMesh& mesh);

/// Removes components other than the one with most triangles, and unused vertices.
TriMesh largestComponent(const TriMesh& mesh);

}  // namespace glenoid
