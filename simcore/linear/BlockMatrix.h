// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>

#include "simcore/linear/AlignedBuffer.h"
#include "simcore/linear/BlockSymbolic.h"

namespace glenoid {

/// Symmetric matrix of 3×3 blocks in the storage of its factor: only the lower triangle after ordering, fill
/// included (zero). A slot is 12 doubles on 32 bytes, column by column with a fourth lane of padding: entry
/// (r, c) of a stored block is slot(s)[4 c + r]. The padding lanes are never read into a result.
/// Diagonal blocks are stored whole and must be symmetric.
class BlockMatrix {
 public:
  explicit BlockMatrix(std::shared_ptr<const BlockSymbolic> symbolic);

  void setZero();
  /// Adds `block`, which stands at the (row, col) the entry was asked for; transposes it where the entry says
  /// so. One call does both triangles. The entry must be in the pattern (assert).
  void add(BlockEntry entry, const Mat3& block);

  double* slot(int index) { return m_values.data() + kSlotSize * static_cast<std::size_t>(index); }
  const double* slot(int index) const {
    return m_values.data() + kSlotSize * static_cast<std::size_t>(index);
  }
  /// All slots one after another: slotCount() × 12 doubles.
  std::span<double> values() { return m_values; }
  std::span<const double> values() const { return m_values; }

  /// The block (row, col), caller's numbering, either triangle; zero where the pattern has none.
  Mat3 block(int row, int col) const;
  /// y = A x, caller's order, 3 blockCount long; y is resized when it does not fit. The same bits whatever
  /// the instruction set. One thread at a time per object (scratch inside).
  void multiply(const VecX& x, VecX& y) const;
  /// Dense copy in the caller's order, for tests and small systems.
  MatX toDense() const;

  const BlockSymbolic& symbolic() const { return *m_symbolic; }
  const std::shared_ptr<const BlockSymbolic>& sharedSymbolic() const { return m_symbolic; }

  static constexpr int kSlotSize = 12;  ///< doubles per stored block

 private:
  std::shared_ptr<const BlockSymbolic> m_symbolic;
  AlignedBuffer m_values;
  mutable AlignedBuffer m_padded;  ///< x and y of multiply, four lanes per block
};

}  // namespace glenoid
