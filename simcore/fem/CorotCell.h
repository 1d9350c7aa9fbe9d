// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <span>

#include "simcore/base/Error.h"
#include "simcore/embed/BoxMoments.h"
#include "simcore/fem/CorotTet.h"

namespace glenoid {

using Mat38 = Eigen::Matrix<double, 3, 8>;
using Mat8 = Eigen::Matrix<double, 8, 8>;
using Mat24 = Eigen::Matrix<double, 24, 24>;

Mat38 cornersOf(const CellBox& box);  ///< as columns, m

/// One material in a box: where it is and what it is.
struct CellTissue {
  BoxMoments moments;
  Lame lame;
};

/// Hexahedral element that turns with its cell: trilinear shape functions integrated over the tissue in the cell, with
/// nine incompatible modes (1 − ξ_a²) e_k condensed inside it, so that a band thinner than the cell, or a bar one cell
/// thick, bends as it should. The modes' strains have their mean over the tissue removed: a constant stress does no work
/// in them, and the patch test holds. Right for small strains and any rotation; a cell that is flat or inside out is
/// pushed back. Cells are boxes at rest, or boxes sheared along one of their directions.
/// Energy ½ uᵀ K u with u = Rᵀ x − x0, R the rotation nearest to F = Σ x_i g_iᵀ, g_i the shape functions' gradients in the
/// mean over the tissue. Frames: W world, E element at rest (its axes are those of the world). SI units.
/// Sources: Wilson, Taylor, Doherty, Ghaboussi 1973 (modes); Taylor, Beresford, Wilson, Int. J. Numer. Methods Eng. 10,
/// 1976 (patch test); Felippa and Haugen, Comput. Methods Appl. Mech. Eng. 194, 2005 (consistent corotational force).
struct CorotCell {
  Mat24 K_E;          ///< condensed rest stiffness, N/m, symmetric, semi-definite; rigid motions give no force
  Mat38 x0_E;         ///< rest corners less the first, m
  Mat38 gradients_E;  ///< g_i as columns, 1/m; they sum to zero
  double volume = 0;  ///< of the tissue, m³, > 0
  Lame lame;          ///< mean over the tissue
  /// Of what follows the stretch law (StretchLaw.h) where the mean stretch is large: no stiffer than K_E is against any mean
  /// strain, so that what is left of K_E is never negative. That of the tissue where there is but one, else of its mean compliance
  /// (Reuss 1929); the rest of a mixed cell stays linear.
  Lame lameLow;
};

struct CellModes;
/// `corners` at rest as columns, m: of a box, or of cells that follow a band (embed/BandShape.h), by the bits of their place.
/// Tissue in the cell's own coordinates. Fails with BadElement when the cell or its tissue has no volume. `modes`: what was
/// condensed, if wanted. The 27 moments integrate the shape functions' gradients exactly where opposite edges of one
/// direction are parallel and of one length, as with cells sheared along it, so the patch test holds there, too.
Result<CorotCell> makeCorotCell(const Mat38& corners, std::span<const CellTissue> tissue, CellModes* modes = nullptr);
inline Result<CorotCell> makeCorotCell(const CellBox& box, std::span<const CellTissue> tissue) { return makeCorotCell(cornersOf(box), tissue); }

/// ∫ N Nᵀ over the tissue, m³: times density the consistent mass of the corners.
Mat8 cellMassShape(const BoxMoments& moments);

/// F = Σ x_i g_iᵀ for corners x_W as columns.
Mat3 deformationGradient(const CorotCell& cell, const Mat38& x_W);

/// Forces on the corners as columns, N, W: minus the exact gradient of the energy, the turning of R included, so that
/// momentum and angular momentum are kept. Where the cell is nearly flat or inside out, so that R is hardly unique,
/// what the turning adds fades out: it could hold the cell there.
Mat38 elasticForce(const CorotCell& cell, const Mat38& x_W, const Mat3& F, const Mat3& R_WE);

/// Elastic energy, J.
double elasticEnergy(const CorotCell& cell, const Mat38& x_W, const Mat3& R_WE);

/// As for tetrahedra (README), with the mean stress over the tissue, J.
double tensionStiffness(const CorotCell& cell, const Mat3& F, const Mat3& R_WE);

}  // namespace glenoid
