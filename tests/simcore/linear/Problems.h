// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <memory>
#include <random>
#include <string>
#include <vector>

#include "simcore/linear/BlockMatrix.h"

/// Matrices and rows for the tests of simcore/linear. All deterministic: a fixed generator, own
/// distributions.
namespace glenoid::test {

class Random {
 public:
  explicit Random(unsigned seed) : m_engine(seed) {}
  /// In [−1, 1).
  double symmetric() { return static_cast<double>(m_engine()) / 2147483648.0 - 1.0; }
  /// In [0, n).
  int below(int n) { return static_cast<int>(m_engine() % static_cast<unsigned>(n)); }
  Vec3 vector() { return {symmetric(), symmetric(), symmetric()}; }
  VecX vector(int size);

 private:
  std::mt19937 m_engine;
};

using Pairs = std::vector<std::array<int, 2>>;

/// A named block graph.
struct Pattern {
  std::string name;
  int blocks;
  Pairs pairs;
};

/// Single block, chains, dense, star, disconnected, grid, random of several densities.
std::vector<Pattern> patterns();

/// Σ over pairs of stiffness-like terms (rank 3, both blocks), plus `shift` on the diagonal: positive
/// definite. With `decades` > 0 the terms are scaled by powers of ten from −decades/2 to decades/2 and resist
/// differences only, as springs do: a common translation costs nothing but the shift, so the condition is
/// scale / shift.
BlockMatrix randomSpd(const Pattern& pattern, unsigned seed, double shift = 1.0, double decades = 0.0);

/// Rows with 1 to `maxTerms` terms at random blocks, ascending.
std::vector<std::vector<RowTerm>> randomRows(int blocks, int count, int maxTerms, unsigned seed);
std::vector<SparseRow> asRows(const std::vector<std::vector<RowTerm>>& rows);
/// J, dense, row by row.
MatX denseRows(const std::vector<std::vector<RowTerm>>& rows, int blocks);

/// A problem of the size of the paper's shoulder (Table 1): seven soft parts of five-tetrahedra cells with
/// 512 nodes, four free rigid bodies (two blocks each), 24 couplings of eight springs between embedded
/// points; 520 blocks in all. Rows of contact between embedded surface points of neighbouring parts.
struct ShoulderSize {
  int tetrahedra = 0;
  std::shared_ptr<const BlockSymbolic> symbolic;
  std::unique_ptr<BlockMatrix> A;
  std::vector<std::vector<RowTerm>> contactRows(int count, unsigned seed) const;
  std::vector<std::vector<std::array<int, 4>>> partTets;  ///< node blocks per part
};
/// `stiffness`: ratio of stiffest to softest part (four decades in the shoulder).
ShoulderSize shoulderSize(double stiffnessRatio = 8000.0);

}  // namespace glenoid::test
