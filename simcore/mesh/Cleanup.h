// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/mesh/TriMesh.h"

namespace glenoid {

/// Vertices nearer than `tolerance` (m, ≥ 0; chains count as one) become their first vertex; triangles that
/// lose a corner and second copies of the same oriented triangle go, then unused vertices. Order is kept.
/// All indices must be valid. Right for files that repeat a vertex in each triangle (STL); not a repair tool.
TriMesh weldVertices(const TriMesh& mesh, double tolerance);

/// Without unused vertices and without triangles that repeat an index. Order is kept. All indices must be
/// valid.
TriMesh compact(const TriMesh& mesh);

/// All triangles turned around.
TriMesh reversed(const TriMesh& mesh);

}  // namespace glenoid
