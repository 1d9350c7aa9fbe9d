// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/base/Math.h"

namespace glenoid {

/// Answer of one search for the rotation of an element.
struct RotationReport {
  int iterations = 0;
  bool converged = true;  ///< false: the cap was reached; the rotation is still a proper one
};

/// Rotation R nearest to the deformation gradient F, that is the maximum of tr(Rᵀ F) over proper rotations,
/// by Newton's method on the quaternion with the last rotation as first guess.
///
/// Right for flattened and inverted elements too: R never becomes a reflection. Where the two smaller
/// singular values are opposite the maximum is not unique; any of them is answered.
/// The Hessian is H = tr(S) I − S with S = sym(Rᵀ F), the gradient the axial vector of Rᵀ F. Where H is not
/// safely positive definite (a saddle, or far away) a damped step along the gradient is taken instead.
/// Frames: F maps rest (element frame E) to world W; R_WE likewise. `guess` must be a unit quaternion.
/// A gradient that is not finite leaves the guess as it is and reports not converged.
RotationReport nearestRotation(const Mat3& F, Quat& R_WE, int iterationCap = 10, double tolerance = 1e-13);

/// The same rotation by singular values, U diag(1, 1, det UVᵀ) Vᵀ: slow, needs no guess; for the reference.
Quat rotationBySvd(const Mat3& F);

}  // namespace glenoid
