// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/base/Math.h"

namespace glenoid {

// Rotations by PlainMath, for all that reaches a state: Eigen's AngleAxis, slerp and angularDistance call the C library.
// Quaternions are unit; q and −q are the same rotation.

/// Rotation about the axis of `angle` by its length, rad.
Quat turnBy(const Vec3& angle);

/// The inverse: axis times angle, rad, the short way round (length ≤ π); near no turn at all 2 vec(q).
Vec3 rotationVector(const Quat& q);

/// Angle between two orientations, rad, 0 … π.
double turnBetween(const Quat& a, const Quat& b);

/// From a (s = 0) to b (s = 1) along the shorter arc at an even pace; exactly a where the two are the same numbers.
/// Source: Shoemake, "Animating rotation with quaternion curves", SIGGRAPH 1985.
Quat turnTowards(const Quat& a, const Quat& b, double s);

/// Eigenvalues, ascending, and unit eigenvectors as columns of a symmetric matrix.
struct SymmetricEigen {
  Vec3 values;
  Mat3 vectors;
};
/// By Jacobi's rotations, in plain arithmetic; error about 1e-15 of the largest eigenvalue. Only the lower half is read.
SymmetricEigen symmetricEigen(const Mat3& matrix);

}  // namespace glenoid
