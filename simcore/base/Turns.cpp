// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/base/Turns.h"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "simcore/base/PlainMath.h"

namespace glenoid {

Quat turnBy(const Vec3& angle) {
  const double size = angle.norm();
  if (!(size > 0)) return Quat::Identity();
  Quat q;
  q.w() = plain::cosine(0.5 * size);
  q.vec() = plain::sine(0.5 * size) / size * angle;
  return q;
}

Vec3 rotationVector(const Quat& q) {
  const double sine = q.vec().norm(), cosine = std::abs(q.w());
  const double side = q.w() < 0 ? -1 : 1;  // the short way round
  return sine > 1e-12 ? Vec3(side * 2 * plain::arcTangent(sine, cosine) / sine * q.vec()) : Vec3(side * 2 * q.vec());
}

double turnBetween(const Quat& a, const Quat& b) {
  const Quat turn = a.conjugate() * b;
  return 2 * plain::arcTangent(turn.vec().norm(), std::abs(turn.w()));
}

Quat turnTowards(const Quat& a, const Quat& b, double s) {
  if (a.coeffs() == b.coeffs()) return a;
  const Vec4 end = a.dot(b) < 0 ? Vec4(-b.coeffs()) : b.coeffs();
  const double arc = 2 * plain::arcTangent((a.coeffs() - end).norm(), (a.coeffs() + end).norm());  // 0 … π/2
  // Below, a straight line differs from the arc by arc²/8: less than the last digit.
  if (arc < 1e-8) return Quat(Vec4(a.coeffs() + s * (end - a.coeffs())));
  const double down = plain::sine(arc);
  return Quat(Vec4(plain::sine((1 - s) * arc) / down * a.coeffs() + plain::sine(s * arc) / down * end));
}

SymmetricEigen symmetricEigen(const Mat3& matrix) {
  Mat3 a = matrix.selfadjointView<Eigen::Lower>(), vectors = Mat3::Identity();
  constexpr int kSweepsMost = 20;  // it converges quadratically: five do
  for (int sweep = 0; sweep < kSweepsMost; ++sweep) {
    const double off = std::abs(a(1, 0)) + std::abs(a(2, 0)) + std::abs(a(2, 1));
    if (!(off > 1e-17 * a.diagonal().cwiseAbs().sum())) break;
    for (const auto& [p, q] : {std::pair(0, 1), std::pair(0, 2), std::pair(1, 2)}) {
      if (a(p, q) == 0) continue;
      // tan of the angle that makes a(p, q) vanish: the smaller root of t² + 2 τ t − 1 = 0.
      const double tau = (a(q, q) - a(p, p)) / (2 * a(p, q));
      const double t = std::copysign(1.0, tau) / (std::abs(tau) + std::sqrt(1 + tau * tau));
      const double c = 1 / std::sqrt(1 + t * t), s = t * c;
      for (Mat3* m : {&a, &vectors}) {  // columns
        const Vec3 left = m->col(p), right = m->col(q);
        m->col(p) = c * left - s * right;
        m->col(q) = s * left + c * right;
      }
      const Eigen::RowVector3d upper = a.row(p), lower = a.row(q);
      a.row(p) = c * upper - s * lower;
      a.row(q) = s * upper + c * lower;
      a(p, q) = a(q, p) = 0;
    }
  }
  std::array<int, 3> order{0, 1, 2};
  std::sort(order.begin(), order.end(), [&](int i, int j) { return a(i, i) < a(j, j) || (a(i, i) == a(j, j) && i < j); });
  SymmetricEigen eigen;
  for (int k = 0; k < 3; ++k) {
    eigen.values[k] = a(order[k], order[k]);
    eigen.vectors.col(k) = vectors.col(order[k]);
  }
  return eigen;
}

}  // namespace glenoid
