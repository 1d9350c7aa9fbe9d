// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <Eigen/Core>
#include <Eigen/Geometry>

/// Short names of the small matrices. Everything is double precision, SI units, column vectors.
namespace glenoid {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Vec4 = Eigen::Vector4d;
using Vec6 = Eigen::Matrix<double, 6, 1>;
using Vec12 = Eigen::Matrix<double, 12, 1>;
using VecX = Eigen::VectorXd;
using Mat3 = Eigen::Matrix3d;
using Mat34 = Eigen::Matrix<double, 3, 4>;
using Mat12 = Eigen::Matrix<double, 12, 12>;
using MatX = Eigen::MatrixXd;
using Quat = Eigen::Quaterniond;
using Box3 = Eigen::AlignedBox3d;

/// Where a rigid frame B stands in the world W: x_W = p_WB + q_WB · x_B.
struct Pose {
  Vec3 p_WB = Vec3::Zero();          ///< m
  Quat q_WB = Quat::Identity();      ///< unit
  Vec3 operator*(const Vec3& x_B) const { return p_WB + q_WB * x_B; }
};

/// Cross-product matrix: skew(a) b = a × b.
inline Mat3 skew(const Vec3& a) {
  Mat3 m;
  m << 0, -a.z(), a.y(), a.z(), 0, -a.x(), -a.y(), a.x(), 0;
  return m;
}

}  // namespace glenoid
