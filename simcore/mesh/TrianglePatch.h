// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/mesh/TriMesh.h"

/// Sets of triangles of one surface, as an author picks them. A set is a list of triangle indices, ascending
/// and without repetition; indices must lie inside the mesh. Neighbours share a vertex, so that growing
/// rounds corners.
namespace glenoid {

/// The set and every triangle that touches it.
std::vector<int> grown(const TriMesh& mesh, const std::vector<int>& set);

/// Without the triangles that touch one outside of the set.
std::vector<int> shrunk(const TriMesh& mesh, const std::vector<int>& set);

/// Every triangle that can be reached from the set: whole pieces of the surface.
std::vector<int> connected(const TriMesh& mesh, const std::vector<int>& set);

/// Every triangle that is not in the set.
std::vector<int> inverted(const TriMesh& mesh, const std::vector<int>& set);

/// Two sets as one; what is in both; the first less the second. No mesh is asked.
std::vector<int> united(const std::vector<int>& a, const std::vector<int>& b);
std::vector<int> common(const std::vector<int>& a, const std::vector<int>& b);
std::vector<int> without(const std::vector<int>& a, const std::vector<int>& b);

/// Area of the set, m².
double areaOf(const TriMesh& mesh, const std::vector<int>& set);

}  // namespace glenoid
