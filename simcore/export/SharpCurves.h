// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/mesh/TriMesh.h"

namespace glenoid::exporting {

/// Creases of a closed surface that a mesher can keep, as curves: edges whose triangles turn by 60° to 120°. Each runs from one
/// place where other than two of them meet to the next, or returns to where it began (first point = last). What hangs together
/// is left out as a whole where it is shorter than `least` (m) in all, holds a sharper edge, or turns back on itself by more
/// than 120° somewhere: that is roughness of a scan or a knife's edge, where refinement would not end. Indices are the surface's
/// vertices.
std::vector<std::vector<int>> sharpCurves(const TriMesh& surface, double least);

}  // namespace glenoid::exporting
