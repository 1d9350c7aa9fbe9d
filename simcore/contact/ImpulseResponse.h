// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <span>

#include "simcore/contact/ContactRows.h"
#include "simcore/linear/BlockCholesky.h"
#include "simcore/linear/ReferenceCholesky.h"

namespace glenoid {

/// How one coupling island answers impulses at its contact rows: what the contact solver needs of an island,
/// the same for every way of solving it. X stands for the matrix behind it: A, or D of the splitting.
class ImpulseResponse {
 public:
  virtual ~ImpulseResponse() = default;
  /// Factors the matrix; false where it is not positive definite.
  virtual bool factor(const BlockMatrix& X) = 0;
  virtual void solve(Eigen::Ref<VecX> x) const = 0;              ///< x ← X⁻¹ x
  virtual void prepare(std::span<const SparseRow> rows) = 0;     ///< what follows is about these rows
  virtual void addDelassus(std::span<const int> rowIds, Eigen::Ref<MatX> W) const = 0;  ///< W += J X⁻¹ Jᵀ
  virtual void addImpulses(std::span<const double> lambda, Eigen::Ref<VecX> v) const = 0;  ///< v += X⁻¹ Jᵀ λ
};

/// By our block Cholesky: W from L⁻¹Jᵀ.
std::unique_ptr<ImpulseResponse> makeCholeskyResponse(std::shared_ptr<const BlockSymbolic> symbolic, bool portable);

/// By CHOLMOD, one refined solve per row: slow, independent of our own factorization.
std::unique_ptr<ImpulseResponse> makeReferenceResponse(std::shared_ptr<const BlockSymbolic> symbolic);

}  // namespace glenoid
