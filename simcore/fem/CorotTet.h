// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>

#include "simcore/base/Error.h"
#include "simcore/base/Math.h"

namespace glenoid {

/// Isotropic elastic constants, Pa.
struct Lame {
  double lambda = 0, mu = 0;
};

/// From Young's modulus (Pa) and Poisson's ratio in [0, 0.5).
Lame lameFrom(double youngsModulus, double poissonRatio);

/// Linear tetrahedron whose stiffness turns with the element: right for large rotations with small strains;
/// an inverted element is pushed back, not repaired.
/// Frames: W world, E element at rest. SI units.
/// With b_i = R g_i (rotated rest gradients) force and stiffness need no 12×12 matrix and lose no digits far
/// from the origin:  f_i = −V R σ g_i with σ = 2µ ε + λ tr ε, ε = sym(Rᵀ F) − I, and
/// K_ij = V (λ b_i b_jᵀ + µ b_j b_iᵀ + µ (b_i·b_j) I).
/// Source: Müller and Gross, "Interactive Virtual Materials", Graphics Interface 2004 (same element).
struct CorotTet {
  Mat34 gradients_E;  ///< g_i: gradients of the four shape functions as columns, 1/m; they sum to zero
  double volume = 0;  ///< rest volume times fill fraction, m³, > 0
  Lame lame;
};

/// x0_E: rest nodes as columns, m. `fill`: fraction of the element that is tissue, in (0, 1]; it weights
/// stiffness (and, by the caller, mass). Fails with BadElement when the rest volume is not positive.
Result<CorotTet> makeCorotTet(const Mat34& x0_E, const Lame& lame, double fill);

/// F = Σ x_i g_iᵀ for nodes x_W as columns.
inline Mat3 deformationGradient(const CorotTet& tet, const Mat34& x_W) {
  return x_W * tet.gradients_E.transpose();
}

/// Rotated gradients b_i = R g_i as columns, 1/m.
inline Mat34 rotatedGradients(const CorotTet& tet, const Mat3& R_WE) { return R_WE * tet.gradients_E; }

/// Forces on the four nodes as columns, N, W. F from deformationGradient.
Mat34 elasticForce(const CorotTet& tet, const Mat3& F, const Mat3& R_WE);

/// Stiffness block −∂f_i/∂x_j at frozen rotation, N/m; the whole is positive semi-definite.
inline Mat3 stiffnessBlock(const CorotTet& tet, const Vec3& b_i, const Vec3& b_j) {
  const double l = tet.volume * tet.lame.lambda, m = tet.volume * tet.lame.mu;
  Mat3 K = (l * b_i) * b_j.transpose() + (m * b_j) * b_i.transpose();
  K.diagonal().array() += m * b_i.dot(b_j);
  return K;
}

/// Half of volume × τ, J, with τ an upper bound of the stiffness (σ_i + σ_j)/(s_i + s_j) that principal stresses σ give
/// against turning in the plane of two principal stretches s; 0 where nothing pulls. README has the derivation.
double tensionStiffness(const CorotTet& tet, const Mat3& F, const Mat3& R_WE);

/// What it adds to stiffnessBlock: t ((b_i·b_j) I − b_j b_iᵀ), positive semi-definite as a whole.
inline Mat3 tensionBlock(double t, const Vec3& b_i, const Vec3& b_j) {
  Mat3 K = (-t * b_j) * b_i.transpose();
  K.diagonal().array() += t * b_i.dot(b_j);
  return K;
}

/// Elastic energy, J, of the corotated strain.
double elasticEnergy(const CorotTet& tet, const Mat3& F, const Mat3& R_WE);

}  // namespace glenoid
