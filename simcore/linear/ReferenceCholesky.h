// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>

#include "simcore/linear/BlockMatrix.h"

namespace glenoid {

/// CHOLMOD behind the same questions as BlockCholesky: an independent solver to check ours against.
/// Slower by an order of magnitude at shoulder size.
/// The symbolic phase is done once; solves are refined twice with residuals in extended precision.
/// Keeps OpenBLAS, where that is the BLAS in use, to one thread in the whole process.
/// Source: Chen, Davis, Hager, Rajamanickam, "Algorithm 887: CHOLMOD", ACM TOMS 2008.
class ReferenceCholesky {
 public:
  enum class Method { Automatic, Simplicial, Supernodal };

  explicit ReferenceCholesky(std::shared_ptr<const BlockSymbolic> symbolic,
                             Method method = Method::Automatic);
  ~ReferenceCholesky();
  ReferenceCholesky(ReferenceCholesky&&) noexcept;
  ReferenceCholesky& operator=(ReferenceCholesky&&) noexcept;

  /// False when A is not positive definite or not finite. A must have the same symbolic.
  bool factor(const BlockMatrix& A);
  /// x ← A⁻¹ x, caller's block order; asserts that the last factor() succeeded.
  void solve(Eigen::Ref<VecX> x);

 private:
  struct Impl;
  std::unique_ptr<Impl> m_impl;
};

}  // namespace glenoid
