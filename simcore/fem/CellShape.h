// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/fem/CorotCell.h"

/// Shape functions and modes of a cell in its box's axes, for CorotCell and CellModes.
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

/// Gradients of the eight shape functions as columns, 1/m.
inline Mat38 shapeGradients(const std::array<double, 3>& xi, const Vec3& edges) {
  Mat38 g;
  for (int i = 0; i < 8; ++i)
    for (int a = 0; a < 3; ++a) {
      const int b = (a + 1) % 3, c = (a + 2) % 3;
      g(a, i) = 0.25 * cornerSign(i, a) * (1 + cornerSign(i, b) * xi[b]) * (1 + cornerSign(i, c) * xi[c]) / edges[a];
    }
  return g;
}

inline Mat6x24 strainsOf(const Mat38& gradients) {
  Mat6x24 B;
  for (int i = 0; i < 8; ++i) B.middleCols<3>(3 * i) = strainOf(gradients.col(i));
  return B;
}

/// Strains of the modes (1 − ξ_a²) e_k, mode 3 a + k: linear in ξ_a.
inline Mat6x9 modeStrains(const std::array<double, 3>& xi, const Vec3& edges) {
  Mat6x9 B;
  for (int a = 0; a < 3; ++a) B.middleCols<3>(3 * a) = strainOf(-4 * xi[a] / edges[a] * Vec3::Unit(a));
  return B;
}

}  // namespace glenoid
