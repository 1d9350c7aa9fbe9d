// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <span>

#include "simcore/linear/AlignedBuffer.h"
#include "simcore/linear/BlockMatrix.h"
#include "simcore/linear/BlockSymbolic.h"
#include "simcore/linear/RowPanels.h"

namespace glenoid {

struct KernelTable;

/// A = L Lᵀ for symmetric positive definite A of 3×3 blocks, and what contact needs from it: solves,
/// Y = L⁻¹Jᵀ for sparse rows, the Delassus matrix W = YᵀY and the answer A⁻¹Jᵀλ to impulses.
/// Left-looking by block columns; all symbolic work lies in BlockSymbolic. In double precision its relative
/// error is about cond(A) · 1e-16, so it serves up to cond 1e12 or so.
/// After the first call of each kind nothing is allocated. One thread at a time per object (scratch inside);
/// the same input gives the same bits.
class BlockCholesky {
 public:
  /// `portable` keeps to plain C++; otherwise the processor's best kernels are taken at run time.
  explicit BlockCholesky(std::shared_ptr<const BlockSymbolic> symbolic, bool portable = false);

  /// False when A is not positive definite to working precision or not finite; then nothing below may be
  /// called. A must share this object's symbolic.
  bool factor(const BlockMatrix& A);

  /// x ← A⁻¹ x, caller's block order, 3 blockCount long.
  void solve(Eigen::Ref<VecX> x) const;

  /// Y = L⁻¹Jᵀ for rows of J in any order. Only the blocks that a row can reach through the elimination tree
  /// are computed and stored. Y is overwritten.
  void halfSolve(std::span<const SparseRow> rows, RowPanels& y) const;

  /// W(rowIds[i], rowIds[j]) += Y_iᵀ Y_j for all pairs of rows of Y: both triangles, exactly symmetric.
  void addDelassus(const RowPanels& y, std::span<const int> rowIds, Eigen::Ref<MatX> W) const;

  /// v += A⁻¹ Jᵀ λ = L⁻ᵀ (Y λ), caller's block order; λ as the rows were given to halfSolve.
  void addImpulses(const RowPanels& y, std::span<const double> lambda, Eigen::Ref<VecX> v) const;

  const BlockSymbolic& symbolic() const { return *m_symbolic; }

 private:
  std::shared_ptr<const BlockSymbolic> m_symbolic;
  const KernelTable* m_kernels;
  AlignedBuffer m_factor;          ///< L by slots; diagonal slots hold the inverse of L's diagonal block
  mutable AlignedBuffer m_padded;  ///< a vector in elimination order, four lanes per block
};

}  // namespace glenoid
