// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/mesh/TetMesh.h"
#include "simcore/mesh/TriMesh.h"

namespace glenoid {

/// Sum of the signed volumes, m³.
double totalVolume(const TetMesh& mesh);

/// Faces that belong to one tetrahedron only, wound outwards; vertices are those of the tetrahedral mesh
/// (same indices, inner ones included, so that a node keeps its number).
TriMesh boundaryOf(const TetMesh& mesh);

/// Shape of a tetrahedron, 1 for a regular and 0 for a flat one, negative when inverted:
/// 12 (3V)^(2/3) / Σ l², the mean ratio. Source: Liu and Joe, "Relationship between tetrahedron shape
/// measures", BIT 1994.
double tetQuality(const TetMesh& mesh, int tet);

struct QualityRange {
  double min = 0, max = 0;
};
/// Over all tetrahedra; zeros for an empty mesh.
QualityRange qualityOf(const TetMesh& mesh);

/// Component of each tetrahedron when two are joined by a common face; numbered from 0 in order of first
/// appearance. `count` receives how many there are when not null.
std::vector<int> faceComponents(const TetMesh& mesh, int* count = nullptr);

/// What is wrong with a tetrahedral mesh: faces of more than two tetrahedra, faces that two tetrahedra see
/// from the same side, tetrahedra without positive volume, indices out of range, nodes in no tetrahedron.
struct TetHealth {
  int overusedFaces = 0, misorientedFaces = 0, badTets = 0, badIndices = 0, unusedNodes = 0, components = 0;
  bool healthy() const { return overusedFaces + misorientedFaces + badTets + badIndices + unusedNodes == 0; }
};
TetHealth healthOf(const TetMesh& mesh);

}  // namespace glenoid
