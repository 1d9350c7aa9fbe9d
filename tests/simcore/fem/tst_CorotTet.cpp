// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <random>

#include "simcore/fem/CorotTet.h"
#include "simcore/fem/Rotation.h"

namespace glenoid {
namespace {

Mat34 restNodes() {
  Mat34 x;
  x << 0, 1.0, 0.2, 0.1, 0, 0.1, 0.9, 0.0, 0, 0.0, 0.1, 1.1;
  return 0.01 * x;
}

CorotTet unitTet(double fill = 1) { return makeCorotTet(restNodes(), lameFrom(5e4, 0.4), fill).value(); }

Mat34 forceAt(const CorotTet& tet, const Mat34& x) {
  const Mat3 F = deformationGradient(tet, x);
  Quat R = Quat::Identity();
  nearestRotation(F, R, 40);
  return elasticForce(tet, F, R.toRotationMatrix());
}

/// Force that a strain of one would give: the scale of every tolerance here.
double forceScale(const CorotTet& tet) { return tet.volume * (tet.lame.lambda + 2 * tet.lame.mu) * tet.gradients_E.norm(); }

TEST(CorotTet, rigidMotionGivesNoForce) {
  const CorotTet tet = unitTet();
  for (const double angle : {0.1, 1.0, 3.0}) {  // rad
    const Mat3 R = Eigen::AngleAxisd(angle, Vec3(1, 2, 3).normalized()).toRotationMatrix();
    const Mat34 x = (R * restNodes()).colwise() + Vec3(0.1, -2.0, 0.4);
    // Two metres away a coordinate of a 1 cm element keeps 1e-14 of relative strain: round-off, nothing else.
    EXPECT_LT(forceAt(tet, x).norm() / forceScale(tet), 1e-12) << angle;
  }
}

TEST(CorotTet, forcesAndTorquesBalance) {
  std::mt19937 random(3);
  std::normal_distribution<double> noise(0, 0.002);
  const CorotTet tet = unitTet();
  const Mat34 x = restNodes() + Mat34::NullaryExpr([&] { return noise(random); });
  const Mat34 f = forceAt(tet, x);
  EXPECT_LT(f.rowwise().sum().norm(), 1e-14 * forceScale(tet));
  Vec3 torque = Vec3::Zero();
  for (int i = 0; i < 4; ++i) torque += x.col(i).cross(f.col(i));
  EXPECT_LT(torque.norm(), 1e-13 * forceScale(tet) * 0.01);
}

TEST(CorotTet, forceIsMinusTheGradientOfTheEnergy) {
  std::mt19937 random(5);
  std::normal_distribution<double> noise(0, 0.001);
  const CorotTet tet = unitTet();
  const Mat34 x = restNodes() + Mat34::NullaryExpr([&] { return noise(random); });
  const auto energy = [&](const Mat34& at) {
    const Mat3 F = deformationGradient(tet, at);
    Quat R = Quat::Identity();
    nearestRotation(F, R, 40);
    return elasticEnergy(tet, F, R.toRotationMatrix());
  };
  // The nearest rotation makes the energy stationary in R, so the whole derivative is the force at fixed R.
  const Mat34 f = forceAt(tet, x);
  const double h = 1e-6;
  for (int i = 0; i < 4; ++i)
    for (int axis = 0; axis < 3; ++axis) {
      Mat34 plus = x, minus = x;
      plus(axis, i) += h;
      minus(axis, i) -= h;
      EXPECT_NEAR(-(energy(plus) - energy(minus)) / (2 * h), f(axis, i), 1e-6 * forceScale(tet));
    }
}

TEST(CorotTet, stiffnessIsTheDerivativeAtFrozenRotation) {
  const CorotTet tet = unitTet();
  const Mat3 R = Eigen::AngleAxisd(0.7, Vec3::UnitY()).toRotationMatrix();
  const Mat34 x = R * restNodes() * 1.05;
  const Mat34 b = rotatedGradients(tet, R);
  const double h = 1e-5;
  for (int j = 0; j < 4; ++j)
    for (int axis = 0; axis < 3; ++axis) {
      Mat34 plus = x, minus = x;
      plus(axis, j) += h;
      minus(axis, j) -= h;
      const Mat34 change = (elasticForce(tet, deformationGradient(tet, plus), R) -
                            elasticForce(tet, deformationGradient(tet, minus), R)) / (2 * h);
      for (int i = 0; i < 4; ++i)
        EXPECT_LT((stiffnessBlock(tet, b.col(i), b.col(j)).col(axis) + change.col(i)).norm(), 1e-8 * forceScale(tet) / 0.01);
    }
}

TEST(CorotTet, stiffnessIsSymmetricSemiDefiniteOfRankSix) {
  const CorotTet tet = unitTet();
  const Mat34 b = rotatedGradients(tet, Mat3::Identity());
  Mat12 K;
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) K.block<3, 3>(3 * i, 3 * j) = stiffnessBlock(tet, b.col(i), b.col(j));
  EXPECT_LT((K - K.transpose()).norm(), 1e-14 * K.norm());
  const Vec12 values = Eigen::SelfAdjointEigenSolver<Mat12>(K).eigenvalues();
  EXPECT_GT(values.minCoeff(), -1e-13 * K.norm());
  for (int i = 0; i < 6; ++i) EXPECT_LT(std::abs(values[i]), 1e-12 * K.norm());
  EXPECT_GT(values[6], 1e-4 * K.norm());
}

TEST(CorotTet, uniaxialStretchMatchesTheClosedForm) {
  // Uniform stretch e along x with free sides: stress E e, sides −ν e.
  const double E = 5e4, nu = 0.4, e = 1e-3;
  const CorotTet tet = unitTet();
  const Mat3 F = (Vec3(1 + e, 1 - nu * e, 1 - nu * e)).asDiagonal();
  const Mat34 f = elasticForce(tet, F, Mat3::Identity());
  for (int i = 0; i < 4; ++i) {
    const Vec3 expected = -tet.volume * E * e * Vec3(tet.gradients_E(0, i), 0, 0);
    EXPECT_LT((f.col(i) - expected).norm(), 1e-12 * forceScale(tet));
  }
}

TEST(CorotTet, fillScalesStiffness) {
  const Mat34 x = 1.1 * restNodes();
  const Mat3 F = deformationGradient(unitTet(), x);
  const Mat34 whole = elasticForce(unitTet(), F, Mat3::Identity()), third = elasticForce(unitTet(1.0 / 3), F, Mat3::Identity());
  EXPECT_LT((whole - 3 * third).norm(), 1e-13 * whole.norm());
}

TEST(CorotTet, invertedElementIsPushedBack) {
  const CorotTet tet = unitTet();
  Mat34 x = restNodes();
  x.col(3) = x.col(0) + (x.col(0) - x.col(3));  // the fourth node through the opposite face
  const Mat34 f = forceAt(tet, x);
  EXPECT_TRUE(f.allFinite());
  EXPECT_GT(f.col(3).dot(restNodes().col(3) - x.col(3)), 0) << "the force points back to the right side";
}

TEST(CorotTet, flatRestShapeIsRefused) {
  Mat34 x = restNodes();
  x.row(2).setZero();
  const Result<CorotTet> flat = makeCorotTet(x, lameFrom(1e4, 0.3), 1);
  ASSERT_FALSE(flat.ok());
  EXPECT_EQ(flat.error().fault, Fault::BadElement);
  Mat34 turned = restNodes();
  turned.col(1).swap(turned.col(2));
  EXPECT_EQ(makeCorotTet(turned, lameFrom(1e4, 0.3), 1).error().fault, Fault::BadElement);
}

}  // namespace
}  // namespace glenoid
