// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "simcore/embed/Cells.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid {

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
