// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <random>

#include "simcore/fem/Rotation.h"

namespace glenoid {
namespace {

Mat3 randomMatrix(std::mt19937& random) {
  std::uniform_real_distribution<double> uniform(-1, 1);
  return Mat3::NullaryExpr([&] { return uniform(random); });
}

double traceWith(const Quat& R, const Mat3& F) { return (R.toRotationMatrix().transpose() * F).trace(); }

TEST(Rotation, agreesWithSingularValuesFromAnyGuess) {
  std::mt19937 random(7);
  for (int i = 0; i < 500; ++i) {
    const Mat3 F = randomMatrix(random);
    Quat R = Quat(Eigen::AngleAxisd(2.0 * (i % 3 - 1), randomMatrix(random).col(0).normalized()));
    nearestRotation(F, R, 60);
    // The maximum itself, not its place: where two singular values nearly cancel the place is ill-conditioned.
    EXPECT_NEAR(traceWith(R, F), traceWith(rotationBySvd(F), F), 1e-10 * F.norm()) << i;
    EXPECT_NEAR(R.norm(), 1, 1e-14);
  }
}

TEST(Rotation, isExactWhereStretchIsModerate) {
  std::mt19937 random(8);
  for (int i = 0; i < 200; ++i) {
    const Quat truth = Quat(Eigen::AngleAxisd(1.2, randomMatrix(random).col(0).normalized()));
    const Mat3 M = randomMatrix(random);
    const Mat3 F = truth.toRotationMatrix() * (Mat3::Identity() + 0.1 * (M + M.transpose()));
    Quat R = Quat::Identity();
    const RotationReport report = nearestRotation(F, R);
    EXPECT_TRUE(report.converged);
    EXPECT_LT(R.angularDistance(truth), 1e-13 * 10) << "iterations " << report.iterations;
  }
}

TEST(Rotation, flatAndInvertedElementsGiveProperRotations) {
  for (const double third : {0.0, -0.2, -1.0}) {
    const Mat3 F = Vec3(1.0, 0.9, third).asDiagonal();
    Quat R = Quat(Eigen::AngleAxisd(0.3, Vec3(1, 2, 3).normalized()));
    nearestRotation(F, R, 40);
    EXPECT_GT(R.toRotationMatrix().determinant(), 0.999999);
    EXPECT_NEAR(traceWith(R, F), traceWith(rotationBySvd(F), F), 1e-10);
  }
}

TEST(Rotation, leavesAStationaryPointThatIsNoMaximum) {
  const Mat3 F = Mat3::Identity();
  Quat R = Quat(Eigen::AngleAxisd(M_PI, Vec3::UnitX()));  // gradient zero, minimum along two axes
  nearestRotation(F, R, 40);
  EXPECT_NEAR(traceWith(R, F), 3, 1e-10);
}

TEST(Rotation, notFiniteKeepsTheGuess) {
  Mat3 F = Mat3::Identity();
  F(1, 2) = NAN;
  Quat R = Quat(Eigen::AngleAxisd(0.5, Vec3::UnitZ()));
  const Quat before = R;
  EXPECT_FALSE(nearestRotation(F, R).converged);
  EXPECT_EQ(R.coeffs(), before.coeffs());
}

}  // namespace
}  // namespace glenoid
