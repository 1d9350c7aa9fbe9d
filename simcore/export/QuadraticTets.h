// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <map>
#include <utility>
#include <vector>

#include "simcore/mesh/TetMesh.h"

namespace glenoid::exporting {

/// Tetrahedra of ten nodes: linear ones with a node in the middle of each edge. They bend, and they do not lock in tissue that
/// hardly changes its volume; linear ones do both wrong.
struct QuadraticTets {
  std::vector<Vec3> nodes;                        ///< first those of the linear mesh, in its order, then the middles
  std::vector<std::array<int, 10>> tets;          ///< corners, then middles of 01, 12, 20, 03, 13, 23
  std::map<std::pair<int, int>, int> middleOf;    ///< of an edge, smaller corner first
};
QuadraticTets quadraticOf(const TetMesh& mesh);

/// The ten shape functions at barycentric coordinates of a tetrahedron, in the order above.
std::array<double, 10> quadraticShape(const std::array<double, 4>& weights);

inline constexpr int kTetEdges[6][2] = {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}};

}  // namespace glenoid::exporting
