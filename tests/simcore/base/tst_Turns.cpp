// SPDX-License-Identifier: GPL-3.0-or-later
// Judged by Eigen's own functions, which call the C library, and by what a rotation must be.
#include "simcore/base/Turns.h"

#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>
#include <numbers>
#include <random>

namespace glenoid {
namespace {

constexpr double kRoundOff = 2e-15;  ///< a few last digits of numbers up to 1

struct Draw {
  std::mt19937 random{3};
  double operator()(double low, double high) { return std::uniform_real_distribution<double>(low, high)(random); }
  Vec3 axis() {
    for (;;)
      if (const Vec3 v((*this)(-1, 1), (*this)(-1, 1), (*this)(-1, 1)); v.norm() > 0.1) return v.normalized();
  }
  Quat turn() { return Quat(Eigen::AngleAxisd((*this)(-3.1, 3.1), axis())); }
};

TEST(Turns, aTurnAboutAnAxisAndItsRotationVectorAreInverses) {
  Draw draw;
  for (int i = 0; i < 2000; ++i) {
    const Vec3 axis = draw.axis();
    const double angle = i % 3 ? draw(0, std::numbers::pi) : std::pow(10, draw(-15, 0));
    const Quat q = turnBy(angle * axis);
    EXPECT_LT((q.coeffs() - Quat(Eigen::AngleAxisd(angle, axis)).coeffs()).norm(), kRoundOff);
    EXPECT_NEAR(q.norm(), 1, kRoundOff);
    EXPECT_LT((rotationVector(q) - angle * axis).norm(), 2 * kRoundOff * (1 + angle));
    EXPECT_EQ(rotationVector(Quat(Vec4(-q.coeffs()))), rotationVector(q)) << "q and −q are one rotation";
  }
  EXPECT_EQ(turnBy(Vec3::Zero()).coeffs(), Quat::Identity().coeffs());
  EXPECT_EQ(rotationVector(Quat::Identity()), Vec3(Vec3::Zero()));
}

TEST(Turns, anglesBetweenOrientations) {
  Draw draw;
  for (int i = 0; i < 2000; ++i) {
    const Quat a = draw.turn(), b = draw.turn();
    EXPECT_NEAR(turnBetween(a, b), a.angularDistance(b), 2 * kRoundOff);
    EXPECT_LT(turnBetween(a, a), kRoundOff);
  }
}

TEST(Turns, onTheWayFromOneOrientationToAnotherThePaceIsEven) {
  Draw draw;
  for (int i = 0; i < 2000; ++i) {
    const Quat a = draw.turn(), b = i % 4 ? draw.turn() : (a * turnBy(std::pow(10, draw(-12, -2)) * draw.axis())).normalized();
    const double s = draw(0, 1), whole = turnBetween(a, b);
    const Quat between = turnTowards(a, b, s);
    EXPECT_LT((between.coeffs() - a.slerp(s, b).coeffs()).norm(), 1e-14);  // Eigen's arccosine is loose near 1
    EXPECT_NEAR(between.norm(), 1, 2 * kRoundOff);
    EXPECT_NEAR(turnBetween(a, between), s * whole, 1e-14);
    EXPECT_LT(turnBetween(turnTowards(a, b, 1), b), 4 * kRoundOff);
  }
  const Quat q = draw.turn();
  EXPECT_EQ(turnTowards(q, q, 0.3).coeffs(), q.coeffs()) << "what does not turn keeps its bits";
}

TEST(Turns, eigenvaluesOfSymmetricMatrices) {
  Draw draw;
  for (int i = 0; i < 3000; ++i) {
    Mat3 m;
    for (int k = 0; k < 9; ++k) m(k / 3, k % 3) = draw(-1, 1) * (i % 3 ? 1 : std::pow(10, draw(-8, 0)));
    m = Mat3(m + m.transpose());
    if (i % 5 == 0) m = Mat3(m * m);                     // near singular at times
    if (i % 7 == 0) m = Mat3(m.diagonal().asDiagonal()); // nothing to do
    const SymmetricEigen mine = symmetricEigen(m);
    const Eigen::SelfAdjointEigenSolver<Mat3> other(m);
    const double size = m.norm();
    EXPECT_LT((mine.values - other.eigenvalues()).norm(), 4 * kRoundOff * size);
    EXPECT_LT((m * mine.vectors - mine.vectors * mine.values.asDiagonal()).norm(), 4 * kRoundOff * size);
    EXPECT_LT((mine.vectors.transpose() * mine.vectors - Mat3::Identity()).norm(), 4 * kRoundOff);
  }
  EXPECT_EQ(symmetricEigen(Mat3::Zero()).values, Vec3(Vec3::Zero()));
}

}  // namespace
}  // namespace glenoid
