// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <vector>

#include "simcore/linear/BlockMatrix.h"

namespace glenoid {

/// When to stop: ‖b − A x‖ ≤ tolerance · ‖b‖ (by the recurrence), or after so many iterations.
struct CgLimits {
  double tolerance;
  int iterations;
};

struct CgReport {
  int iterations;
  double
      residual;  ///< ‖b − A x‖ / ‖b‖ by the recurrence; ‖b‖ = 0 counts as 1. Not an error measure: see README
  bool capped;  ///< stopped by the number of iterations
  bool finite;  ///< false: x is unchanged, the numbers left the range or A is not positive definite
};

/// Scratch; reuse it and nothing is allocated.
struct CgWork {
  VecX r, z, p, q, x;
  std::vector<Mat3> inverseDiagonal;
};

/// Conjugate gradients on A x = b. In: x is the guess (any other length counts as zero); out: the last
/// iterate. The published system used it without preconditioner; `blockJacobi` preconditions with the inverse
/// 3×3 diagonal blocks. Source: Hestenes and Stiefel, J. Res. Nat. Bur. Standards 1952; Saad, "Iterative
/// Methods for Sparse Linear Systems", SIAM 2003, alg. 9.1.
CgReport solveConjugateGradients(const BlockMatrix& A, const VecX& b, VecX& x, const CgLimits& limits,
                                 CgWork& work, bool blockJacobi = false);

/// Scratch of the power iteration.
struct PowerWork {
  VecX x, y, z;
};

/// Largest eigenvalue of D⁻¹A, from below, by power iteration from a fixed start; D symmetric positive
/// definite, applied in place by `applyDinv`. The value is the Rayleigh quotient in the inner product of A,
/// in which D⁻¹A is self-adjoint. 0 for an empty or zero matrix, not-a-number when the iteration left the
/// range.
double estimateLambdaMax(const BlockMatrix& A, const std::function<void(VecX&)>& applyDinv, int iterations,
                         PowerWork& work);
/// The same; allocates, and leaves the last eigenvector estimate in `work`.
double estimateLambdaMax(const BlockMatrix& A, const std::function<void(VecX&)>& applyDinv, int iterations,
                         VecX& work);

}  // namespace glenoid
