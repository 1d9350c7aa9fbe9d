// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/contact/ContactSystem.h"
#include "simcore/contact/KrylovSolve.h"

namespace glenoid {

/// When the friction solve ends.
struct ConeLimits {
  double tolerance = 1e-10;  ///< m/s: what nobody feels
  double enough = 1e-8;      ///< m/s: taken where steps on the exact law bring no more
  int newton = 30;           ///< steps on the exact law, while they get anywhere
  int convex = 60;           ///< then on the convex one
  int turns = 2;             ///< so often, each followed by the exact law again
};

/// Scratch that only grows.
struct ConeWork {
  VecX lambda, lambda0, w, dw, aim, best, newton;
  VecX start, step;         ///< of a step that is shortened
  VecX slip, push, answer;  ///< of the corrections for what is not symmetric
  std::vector<double> penalty, weight, shift;
  std::vector<ConePoint> points, factored;
  std::vector<int> sliding, ranks;
  KrylovWork krylov;
};

/// Contact with Coulomb's friction (Coulomb.h has the law) by the proximal method of multipliers. From impulses λ⁰ and
/// with small compliances ε_i the contacts answer λ_i = P((ε_i λ⁰_i − w_i)/(ε_i + C_i)); Newton's method finds v with
/// A (v − v*) = Jᵀ λ(J v − c), however dependent the contacts are; then λ⁰ ← λ, until that changes nothing: no compliance
/// is left in the answer. If last step's impulses are right, that is seen at once.
///
/// First P is Coulomb's own law (ontoDisk): few steps, quadratic, damped where what sticks and slides changes. Where that
/// ends nowhere, P becomes the projection onto the cone K and w_n is raised by the shift s = μ‖w_t‖ (De Saxcé): for each s
/// that is a convex problem,
///     min over v of ½ (v − v*)ᵀ A (v − v*) + Σ ½ (ε_i + C_i) ‖P_K(z_i)‖²,   z_i = (ε_i λ⁰_i − w_i − s_i n)/(ε_i + C_i),
/// where each Newton step goes down; s follows the slip between solves (nextShift), and where it does, the law is
/// Coulomb's again: the convex problem alone would lift what slides by μ times its slip.
///
/// λ: first guess in, answer out, finite and inside its cones; `exact` says whether the tolerance was reached. In the
/// report `pivots` counts Newton steps, `convex` says that the second law was needed.
/// Sources: Alart and Curnier 1991; De Saxcé and Feng, Math. Comput. Modelling 28 (1998); Acary, Cadoux, Lemaréchal and
/// Malick, ZAMM 91 (2011); Rockafellar, Math. Oper. Res. 1 (1976); Castro, Permenter and Han, "An unconstrained convex
/// formulation of compliant contact", IEEE Trans. Robotics 39 (2023).
LcpReport solveCones(ContactSystem& system, Eigen::Ref<VecX> lambda, const ConeLimits& limits, ConeWork& work);

}  // namespace glenoid
