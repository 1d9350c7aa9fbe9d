// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <Eigen/LU>

#include "simcore/fem/CorotCell.h"

/// Shape functions and modes of a cell by its corners (columns, m), for CorotCell and CellModes.
/// Strains in the order xx, yy, zz, xy, yz, zx, shears doubled.
namespace glenoid {

using Mat6 = Eigen::Matrix<double, 6, 6>;
using Mat6x3 = Eigen::Matrix<double, 6, 3>;
using Mat6x24 = Eigen::Matrix<double, 6, 24>;
using Mat6x9 = Eigen::Matrix<double, 6, 9>;

inline double cornerSign(int corner, int axis) { return corner >> axis & 1 ? 1 : -1; }

/// Strain of a displacement e_k N with the gradient g of N, for k = 0, 1, 2 as columns.
inline Mat6x3 strainOf(const Vec3& g) {
  Mat6x3 B;
  B << g.x(), 0, 0, 0, g.y(), 0, 0, 0, g.z(), g.y(), g.x(), 0, 0, g.z(), g.y(), g.z(), 0, g.x();
  return B;
}

/// Derivatives of the eight shape functions by ξ, η, ζ as columns.
inline Mat38 shapeDerivatives(const std::array<double, 3>& xi) {
  Mat38 d;
  for (int i = 0; i < 8; ++i)
    for (int a = 0; a < 3; ++a) {
      const int b = (a + 1) % 3, c = (a + 2) % 3;
      d(a, i) = 0.125 * cornerSign(i, a) * (1 + cornerSign(i, b) * xi[b]) * (1 + cornerSign(i, c) * xi[c]);
    }
  return d;
}

/// Turns derivatives by ξ, η, ζ into gradients there, 1/m, in a cell with these corners: J⁻ᵀ, J = ∂x/∂ξ.
inline Mat3 toGradients(const std::array<double, 3>& xi, const Mat38& corners) {
  return (corners * shapeDerivatives(xi).transpose()).inverse().transpose();
}

/// Gradients of the eight shape functions as columns, 1/m.
inline Mat38 shapeGradients(const std::array<double, 3>& xi, const Mat38& corners) {
  return toGradients(xi, corners) * shapeDerivatives(xi);
}

inline Mat6x24 strainsOf(const Mat38& gradients) {
  Mat6x24 B;
  for (int i = 0; i < 8; ++i) B.middleCols<3>(3 * i) = strainOf(gradients.col(i));
  return B;
}

/// Strains of the modes (1 − ξ_a²) e_k, mode 3 a + k, with the gradients of ξ, η, ζ in the cell's middle as columns
/// (Taylor, Beresford and Wilson 1976): linear in ξ_a.
inline Mat6x9 modeStrains(const std::array<double, 3>& xi, const Mat3& inMiddle) {
  Mat6x9 B;
  for (int a = 0; a < 3; ++a) B.middleCols<3>(3 * a) = strainOf(-2 * xi[a] * inMiddle.col(a));
  return B;
}

}  // namespace glenoid
