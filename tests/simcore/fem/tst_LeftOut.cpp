// SPDX-License-Identifier: GPL-3.0-or-later
// How much of the force's derivative the linear corotational step leaves out: K holds the rotation still, the
// whole derivative H lets it move with the nodes. The figures stand in simcore/fem/README.md.
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

struct Derivatives {
  Mat12 K, H;
  Mat12 tension;  ///< what the step takes besides K
  double leftOut() const { return (H - K).norm() / K.norm(); }
};

/// At the deformation gradient F with Poisson's ratio nu.
Derivatives derivativesAt(const Mat3& F, double nu) {
  const CorotTet tet = makeCorotTet(restNodes(), lameFrom(5e4, nu), 1).value();
  const Mat34 x = F * restNodes();
  const auto force = [&](const Mat34& at) {
    const Mat3 gradient = deformationGradient(tet, at);
    Quat R = rotationBySvd(gradient);
    nearestRotation(gradient, R);
    return elasticForce(tet, gradient, R.toRotationMatrix());
  };
  Derivatives d;
  const Mat34 b = rotatedGradients(tet, rotationBySvd(F).toRotationMatrix());
  const double t = tensionStiffness(tet, F, rotationBySvd(F).toRotationMatrix());
  const double h = 1e-7;  // 1e-5 of the element: truncation 1e-10, round-off 1e-11
  for (int j = 0; j < 4; ++j)
    for (int axis = 0; axis < 3; ++axis) {
      Mat34 plus = x, minus = x;
      plus(axis, j) += h;
      minus(axis, j) -= h;
      const Mat34 change = (force(minus) - force(plus)) / (2 * h);
      for (int i = 0; i < 4; ++i) {
        d.tension.block<3, 1>(3 * i, 3 * j + axis) = tensionBlock(t, b.col(i), b.col(j)).col(axis);
        d.H.block<3, 1>(3 * i, 3 * j + axis) = change.col(i);
        d.K.block<3, 1>(3 * i, 3 * j + axis) = stiffnessBlock(tet, b.col(i), b.col(j)).col(axis);
      }
    }
  return d;
}

Mat3 turn() {
  return Eigen::AngleAxisd(1.4, Vec3(1, -2, 3).normalized()).toRotationMatrix();
}

/// Symmetric, of the given size, by name of the load.
Mat3 strainOf(const std::string& load, double e, double nu) {
  if (load == "stretch") return Vec3(e, -nu * e, -nu * e).asDiagonal();
  if (load == "squeeze") return Vec3(-e, nu * e, nu * e).asDiagonal();
  if (load == "swell") return e * Mat3::Identity();
  Mat3 shear = Mat3::Zero();
  shear(0, 1) = shear(1, 0) = e;
  return shear;
}

TEST(LeftOut, isNothingAtRestAndInRigidMotion) {
  for (const Mat3& F : {Mat3::Identity().eval(), turn()}) EXPECT_LT(derivativesAt(F, 0.45).leftOut(), 1e-8);
}

TEST(LeftOut, growsInProportionToTheStrain) {
  for (const double nu : {0.3, 0.45, 0.49})
    for (const std::string load : {"stretch", "squeeze", "shear", "swell"}) {
      const auto at = [&](double e) {
        return derivativesAt(turn() * (Mat3::Identity() + strainOf(load, e, nu)), nu).leftOut();
      };
      // Proportional as long as the strain is small against one: 1 % of strain bends the line by less than 2
      // %.
      EXPECT_NEAR(at(1e-2) / at(1e-3), 10, 0.2) << load << " at nu " << nu;
      // Loads that nearly keep the volume leave out a quarter of the strain at most, a change of volume at
      // most 1.8 times it, since K is relative to λ and only then the pressure is too.
      const double share = load == "swell" ? 1.8 : 0.26;
      for (const double e : {1e-3, 1e-2, 0.1, 0.3})
        EXPECT_LT(at(e), share * e) << load << " by " << e << " at nu " << nu;
      EXPECT_GT(derivativesAt(turn() * (Mat3::Identity() + strainOf(load, 0.1, nu)), nu).leftOut(), 1e-4);
    }
}

TEST(LeftOut, isWhatMakesTheWholeDerivativeIndefinite) {
  // Squeezed along one axis to a third, flat, and inside out. K, which the step takes, never has a negative
  // eigenvalue; H has one as large as K itself when flat, and grows as 1/(s₂ + s₃) toward opposite singular
  // values, where the rotation jumps.
  struct Case {
    double third, leftOut, lowest;  ///< third singular value; figures measured at ν 0.45, ±10 %
  };
  for (const Case& c : {Case{0.5, 0.44, -0.30}, Case{0.0, 1.15, -0.84}, Case{-0.5, 3.39, -2.74}}) {
    const Derivatives d = derivativesAt(turn() * Mat3(Vec3(1.0, 0.9, c.third).asDiagonal()), 0.45);
    const double largest = d.K.operatorNorm();
    const auto lowest = [&](const Mat12& m) {
      return Eigen::SelfAdjointEigenSolver<Mat12>(0.5 * (m + m.transpose())).eigenvalues()[0];
    };
    EXPECT_GT(lowest(d.K), -1e-13 * largest);
    EXPECT_NEAR(lowest(d.H) / largest, c.lowest, 0.1 * std::abs(c.lowest)) << c.third;
    EXPECT_NEAR(d.leftOut(), c.leftOut, 0.1 * c.leftOut) << c.third;
    // A force with an energy: H is symmetric even so, up to the truncation of the differences.
    EXPECT_LT((d.H - d.H.transpose()).norm(), 1e-7 * d.H.norm());
  }
}

TEST(LeftOut, tensionsPartBringsTheStepAboveTheWholeDerivative) {
  // H ≤ K + tension as quadratic forms, where K alone falls short of H by about the strain. So a step of an
  // implicit integrator cannot gain energy from it.
  for (const double nu : {0.3, 0.45, 0.49})
    for (const std::string load : {"stretch", "squeeze", "shear", "swell"})
      for (const double e : {1e-3, 1e-2, 0.1, 0.3}) {
        const Derivatives d = derivativesAt(turn() * (Mat3::Identity() + strainOf(load, e, nu)), nu);
        const auto highest = [&](const Mat12& m) {
          return Eigen::SelfAdjointEigenSolver<Mat12>(0.5 * (m + m.transpose())).eigenvalues()[11];
        };
        const double largest = d.K.operatorNorm();
        EXPECT_LT(highest(d.H - d.K - d.tension), 1e-8 * largest) << load << " by " << e << " at nu " << nu;
        EXPECT_LT(highest(-d.tension), 1e-14 * largest) << "semi-definite";
        EXPECT_LT(d.tension.norm(), 2.5 * e * largest) << "no larger than it must be, by a third or so";
        EXPECT_TRUE(load == "squeeze" || highest(d.H - d.K) > 1e-3 * e * largest) << "K alone falls short";
      }
}

}  // namespace
}  // namespace glenoid
