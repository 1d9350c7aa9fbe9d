// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "simcore/base/Error.h"
#include "simcore/mesh/TriMesh.h"

namespace glenoid {

/// What a triangle surface is like: counts of everything that can be wrong, and its measures. Looks at
/// topology and single triangles only; whether the surface cuts itself is asked of countSelfIntersections().
struct MeshHealth {
  int vertices = 0, triangles = 0;
  int badIndices = 0;           ///< triangles that name a vertex which does not exist
  int notFinite = 0;            ///< vertices with NaN or infinity
  int unusedVertices = 0;       ///< in no triangle
  int degenerateTriangles = 0;  ///< a repeated index, or height below 1e-9 of the mesh's diagonal
  int openEdges = 0;            ///< edges of one triangle
  int nonManifoldEdges = 0;     ///< edges of three or more triangles
  int misorientedEdges = 0;     ///< edges that their two triangles run along in the same direction
  int nonManifoldVertices = 0;  ///< vertices whose triangles form more than one fan
  int components = 0;           ///< pieces connected through edges
  int genus = -1;               ///< handles, summed over components; −1 when not a closed manifold
  double volume = 0;            ///< m³, signed; a closed surface wound outwards has more than zero
  double area = 0;              ///< m²

  bool closed() const { return triangles > 0 && badIndices == 0 && openEdges == 0 && nonManifoldEdges == 0; }
  bool manifold() const {
    return badIndices == 0 && nonManifoldEdges == 0 && misorientedEdges == 0 && nonManifoldVertices == 0;
  }
  /// Fit to enclose a volume: finite, closed, manifold, wound outwards, no triangle without area.
  bool healthy() const {
    return closed() && manifold() && notFinite == 0 && degenerateTriangles == 0 && volume > 0;
  }
};

/// Twice the volume over the area, m: of a sheet its thickness, of a shaft its radius; infinite where a surface encloses nothing.
double meanThickness(const TriMesh& mesh);

/// Never fails; a mesh with bad indices gets its counts from the triangles that can be read.
MeshHealth healthOf(const TriMesh& mesh);

/// Done when the mesh is finite, closed, manifold and wound outwards; triangles without area are allowed.
/// Fails with BadIndex, NotFinite, MeshNotClosed (arguments: open edges) or BadMesh; `part` fills the place.
Result<Done> requireClosed(const TriMesh& mesh, const std::string& part = {});

/// Pairs of triangles that cut each other: those without a common vertex that overlap, those with one common
/// vertex where an edge pierces the other; neighbours over an edge are not looked at. Compares along one axis
/// only, so it is for surfaces up to some ten thousand triangles. Touching within 1e-12 of the mesh's
/// diagonal does not count. All indices must be valid.
int countSelfIntersections(const TriMesh& mesh);

}  // namespace glenoid
