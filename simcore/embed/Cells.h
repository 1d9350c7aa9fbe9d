// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/base/Error.h"
#include "simcore/mesh/TetMesh.h"
#include "simcore/mesh/TriMesh.h"

namespace glenoid {

/// Regular cells around a part. The paper's are cubes along the world's axes; turning the frame to a part's
/// principal axes is our addition: it spares a flat oblique ligament the stairs that world axes would cut.
struct CellGrid {
  Pose frame;                        ///< only the rotation matters: the box is centred on the part
  Vec3 cell = Vec3::Constant(0.01);  ///< edges along the frame's axes, m, > 0; nearly equal for good elements
  Vec3 shift = Vec3::Zero();         ///< moves the box by fractions of a cell, each in [0, 1)
  bool operator==(const CellGrid& o) const {
    return frame.p_WB == o.frame.p_WB && frame.q_WB.coeffs() == o.frame.q_WB.coeffs() && cell == o.cell &&
           shift == o.shift;
  }
};

/// The paper's dynamic mesh: bounding box of both surfaces → regular cells → five tetrahedra each, mirrored
/// from cell to cell so that faces match → the tetrahedra that meet the volume which the visual or the
/// collision surface encloses. A tetrahedron meets it when a surface triangle cuts it or when its centroid
/// lies inside; touching within 1e-9 of a cell is not meeting. Every vertex of both surfaces then lies in a
/// tetrahedron. Nodes and tetrahedra are in the order of the cells (x fastest). Nothing is promised about
/// connectedness: two tetrahedra may share only an edge; see chooseCells and faceComponents.
/// Fails as requireClosed does; OutOfRange: cell size not positive, or more than a million cells.
/// Source: paper §4.2 (reference in the README).
Result<TetMesh> embedInCells(const TriMesh& visual, const TriMesh& collision, const CellGrid& grid);
Result<TetMesh> embedInCells(const TriMesh& visual, const TriMesh& collision, double cellSize);

/// `Band`: along the part's principal axes, the third bent as the part is (BandShape.h), for bands thinner than a cell.
enum class GridAxes { World, Principal, Band };
/// Cells along a band are this much wider than they are long: between its ends a band bends along its length, so that is where
/// its cells are needed. With as many tetrahedra as in the paper's table the shipped coracoacromial ligament then gives 0.77 of
/// what fine cells give under a probe; in cubes 0.5.
inline constexpr double kBandCellsWider = 1.6;

/// Principal axes of the area of a surface as a rotation (columns: longest extent first, right-handed).
Quat principalAxes(const TriMesh& surface);

/// Cells, cubic but along a band, whose tetrahedra come nearest to a wanted number.
struct CellChoice {
  CellGrid grid;
  TetMesh mesh;
  double cellSize = 0;  ///< m: the first edge of a cell
};

/// Tries cell sizes and shifts of the grid in a fixed order and takes the count nearest to `targetTets` among
/// those whose tetrahedra form one piece, joined by faces; of equals the one that holds the surface with the
/// least volume. Deterministic. Fails as embedInCells does; Unusable when no size within 15 % gives one
/// piece; OutOfRange for a target outside 1…200 000.
Result<CellChoice> chooseCells(const TriMesh& visual, const TriMesh& collision, int targetTets,
                               GridAxes axes = GridAxes::World);

/// embedInCells with cells of this size along such axes: cubes, but along a band.
Result<TetMesh> embedAlong(const TriMesh& visual, const TriMesh& collision, double cellSize, GridAxes axes);

/// Size of the cells of chooseCells, m; note that its shift of the grid belongs to the answer.
Result<double> cellSizeFor(const TriMesh& visual, const TriMesh& collision, int targetTets,
                           GridAxes axes = GridAxes::World);

}  // namespace glenoid
