// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "simcore/embed/Cells.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid {

/// Corners of a cell are numbered by the bits of their coordinates (x lowest). Four corner tetrahedra and the
/// regular one between; the odd cell is the mirror image, so the diagonals of shared faces agree. All
/// positive.
inline constexpr int kFive[2][5][4] = {
    {{0, 1, 2, 4}, {3, 2, 1, 7}, {5, 4, 7, 1}, {6, 7, 4, 2}, {1, 2, 4, 7}},
    {{1, 0, 5, 3}, {2, 3, 6, 0}, {4, 5, 0, 6}, {7, 6, 3, 5}, {0, 6, 5, 3}},
};

/// The two surfaces of a part with what is asked of them again and again while cells are tried. Internal.
struct EmbeddedSurfaces {
  EmbeddedSurfaces(const TriMesh& visual, const TriMesh& collision);
  std::array<TriangleTree, 2> trees;
};

/// Cells of a grid around a part and which of their tetrahedra are kept. Internal to the cells.
struct Lattice {
  Vec3 origin = Vec3::Zero();  ///< first corner, in the grid's frame
  std::array<int, 3> cells{0, 0, 0};
  std::vector<char> kept;  ///< five for each cell, x fastest
  int count = 0;           ///< kept tetrahedra
};

/// None when the grid would need more than a million cells.
std::optional<Lattice> cutLattice(const EmbeddedSurfaces& surfaces, const CellGrid& grid);

TetMesh meshOf(const Lattice& lattice, const CellGrid& grid);

}  // namespace glenoid
