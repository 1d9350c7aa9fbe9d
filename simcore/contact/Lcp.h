// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <Eigen/Cholesky>
#include <limits>
#include <vector>

#include "simcore/base/Math.h"

namespace glenoid {

/// Linear complementarity problem: find λ ≥ 0 with w = W λ + d ≥ 0 and λᵀ w = 0, W symmetric positive
/// semi-definite (a Delassus matrix), rows × rows. Units: W 1/kg, d and w m/s, λ N·s.
struct LcpLimits {
  int sweeps = 10;            ///< projected Gauss–Seidel before pivoting
  int pivots = 40;            ///< principal pivots; 0: PGS alone
  int activeSetSteps = 20;    ///< where pivoting runs out: so many, and three a row
  bool sweepsLast = true;     ///< false: where that does not end either the first guess stays, for a caller that knows another way
  int lastSweeps = 200;       ///< PGS where that does not end either
  double compliance = 1e-12;  ///< added to the diagonal, relative to it: mends exact duplicates
  double tolerance = 0;       ///< with friction, m/s: an error that nobody feels; round-off of the speeds comes on top
  double enough = 0;          ///< with friction, m/s: taken where further steps bring little; not under the tolerance
  int stepsMost = std::numeric_limits<int>::max();  ///< of any one of the methods, for a caller whose time is bounded
  int turns = 2;              ///< with friction, of the convex law and sweeps where Newton does not end (ConeSolve.h)
};

struct LcpReport {
  int sweeps = 0, pivots = 0;
  int rowSteps = 0;     ///< without friction: of the active set, where pivoting did not end
  bool exact = false;   ///< pivoting ended with every sign right; with friction: the tolerance or what is enough was reached
  bool convex = false;  ///< with friction: Newton on the exact law did not end
  double error = 0;     ///< max |min(λ_i W_ii, w_i)|, m/s
};

/// Scratch that only grows.
struct LcpWork {
  MatX scaled, factor;
  VecX d, lambda, w, scale, best, rhs, cosine, sine;
  std::vector<int> active;
  std::vector<char> isActive;
};

/// λ: first guess in, answer out. Every answer is finite and not negative.
/// PGS gives a guess of the active set, block principal pivoting makes it exact; where that cycles (many dependent
/// rows), a primal active set begins with nothing and takes in one row at a time (ActiveSet.h); where that ends at a dependent row
/// too, PGS has the last word and the report says so.
/// Source: Júdice and Pires, "A block principal pivoting algorithm for large-scale strictly monotone linear
/// complementarity problems", Computers & Operations Research 21 (1994).
LcpReport solveLcp(const Eigen::Ref<const MatX>& W, const Eigen::Ref<const VecX>& d, Eigen::Ref<VecX> lambda,
                   const LcpLimits& limits, LcpWork& work);

}  // namespace glenoid
