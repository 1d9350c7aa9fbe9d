// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/mesh/TetMesh.h"

/// Sets of nodes of one tetrahedral mesh, as an author picks them. A set is a list of node indices, ascending and
/// without repetition; indices must lie inside the mesh. Neighbours share a tetrahedron. Nodes of no tetrahedron are in
/// no set that is made here.
namespace glenoid {

/// The nodes of some tetrahedron, ascending.
std::vector<int> usedNodes(const TetMesh& mesh);

/// The set and every node that has a tetrahedron in common with it.
std::vector<int> grownNodes(const TetMesh& mesh, const std::vector<int>& set);

/// Without the nodes that have a tetrahedron in common with one outside of the set.
std::vector<int> shrunkNodes(const TetMesh& mesh, const std::vector<int>& set);

/// Every node that can be reached from the set: whole pieces of the mesh.
std::vector<int> connectedNodes(const TetMesh& mesh, const std::vector<int>& set);

/// Every used node that is not in the set.
std::vector<int> invertedNodes(const TetMesh& mesh, const std::vector<int>& set);

/// Edge of a cell of five or six tetrahedra of the mesh's mean volume, m; 0 for an empty mesh.
double meanCellEdge(const TetMesh& mesh);

}  // namespace glenoid
