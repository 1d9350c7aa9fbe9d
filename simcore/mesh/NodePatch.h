// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <limits>
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

/// Of some nodes the one nearest to a place, of equals the first; −1 at an infinite distance where there are none. Metres.
struct NearestNode {
  int node = -1;
  double distance = std::numeric_limits<double>::infinity();
};
NearestNode nearestNode(const TetMesh& mesh, const std::vector<int>& nodes, const Vec3& place);

/// Half the diagonal of a cube with this edge: a place in such a cell has a corner no farther than that (and rounding).
double halfDiagonalOf(double cellEdge);

/// Edge of a cell of five or six tetrahedra of the mesh's mean volume, m; 0 for an empty mesh.
double meanCellEdge(const TetMesh& mesh);

}  // namespace glenoid
