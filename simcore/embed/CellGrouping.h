// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <map>
#include <vector>

#include "simcore/base/Error.h"
#include "simcore/embed/BoxMoments.h"
#include "simcore/mesh/TetMesh.h"

namespace glenoid {

/// One box of those that tetrahedra were cut from.
struct GroupedCell {
  CellBox box;
  int parity = 0;              ///< which of kFive it was cut by
  std::array<int, 8> corners;  ///< in CellGrouping::nodes
  std::array<int, 3> low, high;  ///< places of its faces among all of its axis, ascending
};

/// The boxes that a mesh's tetrahedra were cut from. Internal to the cells.
struct CellGrouping {
  std::vector<Vec3> nodes;         ///< those of the mesh, then corners that it lacks, m
  std::vector<GroupedCell> cells;  ///< in the order in which the mesh's tetrahedra name them

  /// The cell one step on along each axis (−1, 0, 1), or −1.
  int neighbour(int cell, const std::array<int, 3>& step) const;

  std::map<std::array<int, 3>, int> byLow;
};

/// Fails with Unusable where some tetrahedron is no fifth of a box, as kFive cuts it, in the frame of the others.
Result<CellGrouping> groupIntoCells(const TetMesh& cut);

}  // namespace glenoid
