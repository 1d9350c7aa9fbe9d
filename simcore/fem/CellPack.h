// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace glenoid {

inline constexpr int kCellBlocks = 36;

/// Local nodes of the blocks on and below the diagonal of a cell's matrix.
struct CellPairs {
  int pair[kCellBlocks][2];
};
inline constexpr CellPairs kCellPairs = [] {
  CellPairs pairs{};
  int k = 0;
  for (int i = 0; i < 8; ++i) pairs.pair[k][0] = i, pairs.pair[k++][1] = i;
  for (int i = 1; i < 8; ++i)
    for (int j = 0; j < i; ++j) pairs.pair[k][0] = i, pairs.pair[k++][1] = j;
  return pairs;
}();

/// Four corotational cells side by side, lane by lane, as ElementPack holds tetrahedra. The same element as CorotCell;
/// tests compare the two. Unused lanes repeat an element without stiffness and write nowhere.
struct alignas(32) CellPack {
  double stiffness[kCellBlocks][3][3][4];  ///< [block][row][column][lane], N/m
  double rest[8][3][4];                    ///< corners less the first, m
  double gradients[8][3][4];               ///< mean over the tissue, 1/m
  double lambda[4], mu[4];                 ///< volume × Lamé constant, J: of the mean stress
  double stiffnessDamping[4];              ///< Rayleigh β, s
  int node[4][8];                          ///< [lane][corner], of the object
  int count;                               ///< lanes in use
};

/// Where and how the stiffness of four cells goes, in the order of kCellPairs; as PackTarget.
struct CellTarget {
  double* slot[4][kCellBlocks];
  bool turned[4][kCellBlocks];
  double tension = 1;
};

struct alignas(32) CellResult {
  double force[8][3][4];    ///< [corner][axis][lane], N
  double quaternion[4][4];  ///< [lane][x y z w]
  bool settled[4];          ///< where not, the caller must take the cell singly
  bool strained[4];         ///< as PackResult
};

/// As PackKernel.
using CellKernel = void (*)(const CellPack& pack, const double* nodes, const double* const quaternions[4], double dt,
                            double damping, const CellTarget& target, CellResult& result);

/// The best kernel of this processor, or the portable one, with the same bits.
CellKernel cellKernel(bool portable);

void cellPackPortable(const CellPack&, const double*, const double* const[4], double, double, const CellTarget&, CellResult&);
void cellPackAvx2(const CellPack&, const double*, const double* const[4], double, double, const CellTarget&, CellResult&);

}  // namespace glenoid
