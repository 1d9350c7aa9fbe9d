// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/contact/FrictionCone.h"

#include <algorithm>
#include <cmath>

namespace glenoid {

namespace {

/// Inside the cone, or without friction: what both laws have in common. False where the contact slides.
bool plain(const Vec3& z, double mu, double length, ConePoint& point) {
  if (!(mu > 0)) {
    if (!(z[0] > 0)) return true;
    point.impulse[0] = z[0];
    point.root(0, 0) = 1;
    point.rank = 1;
    return true;
  }
  if (length > mu * z[0]) return false;
  point.impulse = z;
  point.root.setIdentity();
  point.rank = 3;
  return true;
}

}  // namespace

ConePoint ontoCone(const Vec3& z, double mu) {
  ConePoint point;
  const double length = std::sqrt(z[1] * z[1] + z[2] * z[2]);
  if (plain(z, mu, length, point)) return point;
  const double n = (z[0] + mu * length) / (1 + mu * mu);
  if (!(n > 0)) return point;  // length is not zero: z[0] ≥ 0 would be inside
  const double c = z[1] / length, s = z[2] / length;
  point.impulse = n * Vec3(1, mu * c, mu * s);
  point.root.col(0) = Vec3(1, mu * c, mu * s) / std::sqrt(1 + mu * mu);
  point.root.col(1) = std::sqrt(mu * n / length) * Vec3(0, -s, c);
  point.rank = 2;
  return point;
}

ConePoint ontoDisk(const Vec3& z, double mu) {
  ConePoint point;
  const double length = std::sqrt(z[1] * z[1] + z[2] * z[2]);
  if (plain(z, mu, length, point) || !(z[0] > 0)) return point;
  point.along = z.tail<2>() / length;
  point.drag = mu;
  point.impulse << z[0], mu * z[0] * point.along;
  point.root(0, 0) = 1;
  point.root.col(1) = std::sqrt(mu * z[0] / length) * Vec3(0, -point.along[1], point.along[0]);
  point.rank = 2;
  return point;
}

double coulombError(const Vec3& lambda, const Vec3& w, double mu, double kappa) {
  const double normal = std::abs(std::min(kappa * lambda[0], w[0]));
  const double radius = mu * kappa * std::max(0.0, lambda[0]);
  const Eigen::Vector2d t = kappa * lambda.tail<2>(), aim = t - w.tail<2>();
  const double length = aim.norm();
  const Eigen::Vector2d onDisk = length <= radius ? aim : Eigen::Vector2d(radius / length * aim);
  return std::max(normal, (t - onDisk).norm());
}

}  // namespace glenoid
