// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <vector>

#include "simcore/base/Math.h"

namespace glenoid {

/// Mass of two nodes together: M has mass · I at (row, col) and at (col, row).
struct MassPair {
  int row = 0, col = 0;  ///< nodes, row ≥ col
  double mass = 0;       ///< kg; off the diagonal too, so not negative in a tetrahedron that is full
  double drag = 0;       ///< kg/s: Rayleigh α times mass
};

/// Consistent mass matrix of a soft object: shape functions integrated over its tissue, so that a node has mass together
/// with its neighbours and every motion that the shape functions hold has its exact momentum and energy. Constant.
/// Source: Archer, "Consistent mass matrix for distributed mass systems", J. Struct. Div. ASCE 89, 1963.
class MassMatrix {
 public:
  MassMatrix() = default;
  /// Pairs in any order, several of them for the same nodes add up in the order given; every node gets a diagonal.
  MassMatrix(int nodeCount, std::vector<MassPair> loose);

  /// First the diagonals, one for each node in their order, then the others, ascending by row and column.
  const std::vector<MassPair>& pairs() const { return m_pairs; }
  double total() const;  ///< kg

  /// out += M v + uniform part: out_i += Σ_j M_ij (v_j + w). `v` and `out` hold three numbers a node. Allocates nothing.
  void addProduct(const Eigen::Ref<const VecX>& v, const Vec3& w, Eigen::Ref<VecX> out) const;

 private:
  int m_nodeCount = 0;
  std::vector<MassPair> m_pairs;
};

}  // namespace glenoid
