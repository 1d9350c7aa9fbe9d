// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/fem/Rotation.h"

#include <Eigen/SVD>
#include <cmath>

#include "simcore/base/Turns.h"

namespace glenoid {

namespace {

/// Solves the symmetric 3×3 system by its adjugate; false where H is not safely positive definite.
bool solvePositive(const Mat3& H, const Vec3& a, double scale, Vec3& x) {
  const double c00 = H(1, 1) * H(2, 2) - H(1, 2) * H(1, 2);
  const double c01 = H(0, 2) * H(1, 2) - H(0, 1) * H(2, 2);
  const double c02 = H(0, 1) * H(1, 2) - H(0, 2) * H(1, 1);
  const double det = H(0, 0) * c00 + H(0, 1) * c01 + H(0, 2) * c02;
  const double minor = H(0, 0) * H(1, 1) - H(0, 1) * H(0, 1);
  const double s2 = scale * scale;
  if (!(H(0, 0) > 1e-3 * scale) || !(minor > 1e-6 * s2) || !(det > 1e-9 * s2 * scale)) return false;
  const double c11 = H(0, 0) * H(2, 2) - H(0, 2) * H(0, 2);
  const double c12 = H(0, 1) * H(0, 2) - H(0, 0) * H(1, 2);
  x = Vec3(c00 * a.x() + c01 * a.y() + c02 * a.z(), c01 * a.x() + c11 * a.y() + c12 * a.z(),
           c02 * a.x() + c12 * a.y() + minor * a.z()) /
      det;
  return true;
}

/// Newton with the curvatures made positive: away from saddles and minima, toward the maximum. Where the slope
/// vanishes although a curvature has the wrong sign, along that curvature.
Vec3 uphill(const Mat3& H, const Vec3& gradient, double scale) {
  const SymmetricEigen eigen = symmetricEigen(H);
  Vec3 step = eigen.vectors.transpose() * gradient;
  const bool isFlat = gradient.norm() <= 1e-12 * scale;
  for (int i = 0; i < 3; ++i) step[i] /= std::max(std::abs(eigen.values[i]), 1e-3 * scale);
  if (isFlat && eigen.values[0] < -1e-9 * scale) step = Vec3(0.5, 0, 0);
  return eigen.vectors * step;
}

}  // namespace

RotationReport nearestRotation(const Mat3& F, Quat& R_WE, int iterationCap, double tolerance) {
  RotationReport report;
  const double scale = F.norm();
  if (!std::isfinite(scale)) return {0, false};
  if (scale == 0) return report;  // a point: every rotation is as good as the last one
  for (int i = 0; i < iterationCap; ++i) {
    const Mat3 M = R_WE.toRotationMatrix().transpose() * F;
    // d/dω tr(exp(−ω) M) at 0, with the update R ← R exp(ω).
    const Vec3 gradient(M(2, 1) - M(1, 2), M(0, 2) - M(2, 0), M(1, 0) - M(0, 1));
    const Mat3 S = 0.5 * (M + M.transpose());
    const Mat3 H = S.trace() * Mat3::Identity() - S;
    Vec3 omega;
    if (!solvePositive(H, gradient, scale, omega)) {
      omega = uphill(H, gradient, scale);
      if (omega.norm() <= 1e-12) return report;
    }
    const double angle = omega.norm();
    if (angle > 1.5) omega *= 1.5 / angle;  // beyond that Newton's model says nothing about the sphere
    const Quat turn(1.0, 0.5 * omega.x(), 0.5 * omega.y(), 0.5 * omega.z());
    R_WE = (R_WE * turn).normalized();
    report.iterations = i + 1;
    if (angle < tolerance) return report;
    // Newton converges quadratically: a step of 1e-8 leaves an error below round-off.
    if (angle < 1e-8) return report;
  }
  report.converged = false;
  return report;
}

Quat rotationBySvd(const Mat3& F) {
  const Eigen::JacobiSVD<Mat3> svd(F, Eigen::ComputeFullU | Eigen::ComputeFullV);
  const Mat3 product = svd.matrixU() * svd.matrixV().transpose();
  const Vec3 signs(1, 1, product.determinant() < 0 ? -1 : 1);
  return Quat(Mat3(svd.matrixU() * signs.asDiagonal() * svd.matrixV().transpose())).normalized();
}

}  // namespace glenoid
