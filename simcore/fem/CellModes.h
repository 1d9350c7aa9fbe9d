// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/fem/CorotCell.h"

namespace glenoid {

/// What the condensed modes of a CorotCell do inside it, for whoever asks for the strain at a place of the cell: with the
/// corners' displacements u the modes have a = response · u, and ε = B(ξ) u + (G(ξ) − mean G) a. In E.
struct CellModes {
  Mat38 corners_E;                         ///< at rest less the first, m
  Mat3 inMiddle_E;                         ///< gradients of ξ, η, ζ in the cell's middle as columns, 1/m
  Eigen::Matrix<double, 6, 9> mean;        ///< of the modes' strains over the tissue, 1/m
  Eigen::Matrix<double, 9, 24> response;   ///< −K_aa⁻¹ K_uaᵀ
};

/// Small strain at ξ (−1 … 1 along the cell's edges) for displacements u_E of the corners as columns, m: symmetric, in E.
Mat3 strainAt(const CellModes& modes, const Vec3& xi, const Mat38& u_E);

}  // namespace glenoid
