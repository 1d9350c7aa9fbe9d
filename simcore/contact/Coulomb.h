// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <span>

#include "simcore/contact/Lcp.h"

namespace glenoid {

/// Where a contact's unknowns stand: `row` is its normal impulse; with friction the two rows after it are its
/// tangential impulses along two orthogonal directions. Contacts come ascending by row, without holes.
struct ContactUnknowns {
  int row = 0;
  bool tangential = false;
  double friction = 0;  ///< Coulomb's coefficient
  int rows() const { return tangential ? 3 : 1; }
};

/// Scratch that only grows.
struct CoulombWork {
  MatX scaled, jacobian;
  VecX d, lambda, w, scale, best, step;
  std::vector<ContactUnknowns> contacts;  ///< friction in scaled units
  std::vector<int> unknowns;              ///< rows of contacts that are closed
};

/// Contact with dry friction: for each contact, with w = W λ + d the relative velocity along its rows,
///   0 ≤ λ_n ⊥ w_n ≥ 0,   ‖λ_t‖ ≤ μ λ_n,   w_t = 0 or λ_t = −μ λ_n w_t / ‖w_t‖
/// (Coulomb's law with the round cone, no facets; sliding makes the problem non-symmetric, so there need be
/// neither a solution nor only one). W symmetric positive semi-definite; units as in Lcp.h.
/// Block projected Gauss–Seidel gives a guess, Newton's method on the projected form makes it exact; where that
/// does not settle, the best answer stays and the report says so. Every answer is finite and inside the cones.
/// λ: first guess in, answer out. In the report `pivots` counts Newton steps.
/// Sources: Alart and Curnier, "A mixed formulation for frictional contact problems prone to Newton like solution
/// methods", Comput. Methods Appl. Mech. Eng. 92 (1991); Jourdan, Alart and Jean, "A Gauss–Seidel like algorithm
/// to solve frictional contact problems", ibid. 155 (1998).
LcpReport solveCoulomb(const Eigen::Ref<const MatX>& W, const Eigen::Ref<const VecX>& d,
                       std::span<const ContactUnknowns> contacts, Eigen::Ref<VecX> lambda, const LcpLimits& limits,
                       CoulombWork& work);

}  // namespace glenoid
