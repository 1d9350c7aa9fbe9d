// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <span>

#include "simcore/contact/ConeSolve.h"
#include "simcore/contact/ImpulseSystem.h"

namespace glenoid {

/// From so many rows on the friction solve is bounded by what it costs: the number of its steps falls as rows grow.
inline constexpr int kManyRows = 500;

/// Scratch that only grows.
struct CoulombWork {
  ImpulseSystem system;
  ConeWork cones;
  VecX lambda, w, best;
};

/// Contact with dry friction: for each contact, with w = W λ + d the relative velocity along its rows,
///   0 ≤ λ_n ⊥ w_n ≥ 0,   ‖λ_t‖ ≤ μ λ_n,   w_t = 0 or λ_t = −μ λ_n w_t / ‖w_t‖
/// (Coulomb's law with the round cone, no facets; sliding makes the problem non-symmetric, so there need be
/// neither a solution nor only one). W symmetric positive semi-definite; units as in Lcp.h.
/// By solveCones (ConeSolve.h has the method); with limits.pivots = 0 by block projected Gauss–Seidel alone, as the
/// `paper` profile asks. Ends when the law holds to limits.tolerance and 1e-11 of the largest speed in d, or to limits.enough
/// where steps bring no more; where that is not reached, the best answer stays and the report says so. Every answer is finite and inside the cones.
/// λ: first guess in, answer out. In the report `pivots` counts Newton steps.
/// Sources: Alart and Curnier, "A mixed formulation for frictional contact problems prone to Newton like solution
/// methods", Comput. Methods Appl. Mech. Eng. 92 (1991); Jourdan, Alart and Jean, "A Gauss–Seidel like algorithm
/// to solve frictional contact problems", ibid. 155 (1998).
LcpReport solveCoulomb(const Eigen::Ref<const MatX>& W, const Eigen::Ref<const VecX>& d,
                       std::span<const ContactUnknowns> contacts, Eigen::Ref<VecX> lambda, const LcpLimits& limits,
                       CoulombWork& work);

/// When the friction solve ends: limits.tolerance and limits.enough with what round-off leaves of speeds d.
ConeLimits coneLimits(const LcpLimits& limits, const Eigen::Ref<const VecX>& d);

}  // namespace glenoid
