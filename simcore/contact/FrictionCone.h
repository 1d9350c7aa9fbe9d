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

/// Rows of one contact out of a vector over all rows: (normal, tangent, tangent); zeros along tangents it lacks.
inline Vec3 rowsOf(const ContactUnknowns& contact, const VecX& rows) {
  if (contact.tangential) return rows.segment<3>(contact.row);
  return Vec3(rows[contact.row], 0, 0);
}
inline void setRowsOf(const ContactUnknowns& contact, const Vec3& value, VecX& rows) {
  if (contact.tangential)
    rows.segment<3>(contact.row) = value;
  else
    rows[contact.row] = value[0];
}

/// A contact's impulse as a function of z = (n, t₁, t₂), what its speeds ask for, and the derivative of it: symmetric
/// part root·rootᵀ over the first `rank` columns (3: sticks, 2: slides, 0: open), and beside it, for the exact law only,
/// what the tangents gain with the normal, `drag`·(0, along).
struct ConePoint {
  Vec3 impulse = Vec3::Zero();
  Mat3 root = Mat3::Zero();
  int rank = 0;
  double drag = 0;
  Eigen::Vector2d along = Eigen::Vector2d::Zero();
};

/// The convex law: the nearest point of the cone K = {‖t‖ ≤ μ n}. Its derivative is symmetric, but a contact that slides
/// lifts.
ConePoint ontoCone(const Vec3& z, double mu);

/// Coulomb's own law, after Alart and Curnier: n cut at zero, then t cut to the disk of radius μ n.
ConePoint ontoDisk(const Vec3& z, double mu);

/// How far the impulses λ are from Coulomb's law with the speeds w of their rows, m/s: from their own projection, in
/// units of the contact's own answer κ, 1/kg, to an impulse. Zero exactly where 0 ≤ λ_n ⊥ w_n ≥ 0, ‖λ_t‖ ≤ μ λ_n and
/// λ_t is against the slip at the edge of its disk unless w_t = 0 (Alart and Curnier 1991).
double coulombError(const Vec3& lambda, const Vec3& w, double mu, double kappa);

}  // namespace glenoid
