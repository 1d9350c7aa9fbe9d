// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <optional>
#include <vector>

#include "simcore/base/Error.h"
#include "simcore/embed/BandShape.h"
#include "simcore/embed/BoxMoments.h"
#include "simcore/mesh/TetMesh.h"
#include "simcore/mesh/TriMesh.h"

namespace glenoid {

/// A part's tetrahedra made up to whole cells, for elements of eight nodes, with the moments of the tissue in each.
/// Frame W at rest, SI units. Cells that follow a band are boxes once it is flat: `boxes` and `tissue` are then those of
/// the flat band, `mesh` is that of the part.
struct CellMesh {
  TetMesh mesh;                              ///< five tetrahedra a cell, in the order of the cells
  std::optional<BandShape> band;             ///< that the cells follow
  std::vector<CellBox> boxes;                ///< one a cell
  std::vector<std::array<int, 8>> corners;   ///< nodes of each cell, by the bits of their place, x lowest
  std::vector<BoxMoments> tissue;            ///< of each tetrahedron's share of the tissue, in its cell's coordinates
};

/// Recognises the cells that embedInCells has cut (by the tetrahedra themselves, so a mesh from a file will do; cells may
/// differ in size along an axis as long as they are boxes in one frame) and adds the corners that no kept tetrahedron
/// had. `closed`: the surface whose inside is tissue. A cell that holds none is left out. One that holds a sliver just
/// beyond a neighbour's face, edge or corner is left out too, and its tissue counts in the neighbour, whose polynomials
/// go on there: otherwise nodes with next to no stiffness would hold the surface. Not so where that would take the part
/// asunder. Old nodes come first, in their order, less those that no cell needs any more. Deterministic.
/// Where the tetrahedra are no boxes the same is tried with the part made flat (BandShape.h).
/// Fails with Unusable where the tetrahedra are not fives of boxes in one frame either way.
/// Source of the second rule: Badia, Verdugo, Martín, "The aggregated unfitted finite element method", Comput. Methods
/// Appl. Mech. Eng. 336, 2018.
Result<CellMesh> wholeCells(const TetMesh& cut, const TriMesh& closed);

}  // namespace glenoid
