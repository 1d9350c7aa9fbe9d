// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <random>

#include "simcore/contact/Coulomb.h"

namespace glenoid {
namespace {

std::vector<ContactUnknowns> frictional(int contacts, double mu) {
  std::vector<ContactUnknowns> list;
  for (int c = 0; c < contacts; ++c) list.push_back({3 * c, true, mu});
  return list;
}

/// Contacts of a few bodies of very different mass: W = J M⁻¹ Jᵀ with `directions` degrees of freedom.
struct Problem {
  MatX W;
  VecX d;
};
Problem randomProblem(int contacts, int directions, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const MatX J = MatX::NullaryExpr(3 * contacts, directions, [&] { return normal(random); });
  VecX inverseMass(directions);
  for (int i = 0; i < directions; ++i) inverseMass[i] = std::pow(10.0, i % 3 - 1);
  const VecX v = VecX::NullaryExpr(directions, [&] { return normal(random); });
  return {J * inverseMass.asDiagonal() * J.transpose(), J * v};  // d in the range: approach speeds of a real motion
}

/// The three laws, with speeds and impulses scaled by what one contact alone would see.
void expectCoulomb(const Problem& problem, double mu, const VecX& lambda, double tolerance) {
  const VecX w = problem.W * lambda + problem.d;
  for (Eigen::Index i = 0; i < w.size(); i += 3) {
    const double answer = problem.W(i, i);
    const Eigen::Vector2d t = lambda.segment<2>(i + 1), slip = w.segment<2>(i + 1);
    EXPECT_GE(lambda[i], 0);
    EXPECT_GT(w[i], -tolerance);
    EXPECT_LT(std::min(lambda[i] * answer, w[i]), tolerance) << "Signorini, row " << i;
    EXPECT_LE(t.norm(), mu * lambda[i] * (1 + 1e-12) + 1e-15) << "cone, row " << i;
    // Either it sticks, or the impulse is at the edge and against the slip.
    const double room = mu * lambda[i] - t.norm(), against = (slip.norm() * t + mu * lambda[i] * slip).norm();
    EXPECT_LT(std::min(slip.norm(), room * answer), tolerance) << "stick or slide, row " << i;
    EXPECT_LT(against * answer, tolerance * (1 + mu * lambda[i] * answer)) << "against the slip, row " << i;
  }
}

TEST(Coulomb, oneBodySticksOrSlidesInClosedForm) {
  const double mass = 2, mu = 0.5;
  const MatX W = MatX::Identity(3, 3) / mass;
  CoulombWork work;
  for (const double slip : {0.2, -0.45, 2.0}) {
    VecX lambda = VecX::Zero(3);
    EXPECT_TRUE(solveCoulomb(W, Vec3(-1, slip, 0), frictional(1, mu), lambda, {}, work).exact);
    EXPECT_NEAR(lambda[0], mass, 1e-10);
    EXPECT_NEAR(lambda[1], -std::clamp(slip, -mu, mu) * mass, 1e-10);
    EXPECT_NEAR(lambda[2], 0, 1e-12);
  }
  VecX lambda = Vec3(3, 1, 1);
  EXPECT_TRUE(solveCoulomb(W, Vec3(0.1, 5, 0), frictional(1, mu), lambda, {}, work).exact);
  EXPECT_EQ(lambda.norm(), 0) << "it flies off";
}

TEST(Coulomb, randomProblemsObeyTheLaw) {
  CoulombWork work;
  for (const int contacts : {1, 3, 10, 40})
    for (unsigned seed = 0; seed < 10; ++seed) {
      const Problem problem = randomProblem(contacts, 4 * contacts + 2, 100 * contacts + seed);
      VecX lambda = VecX::Zero(3 * contacts);
      const LcpReport report = solveCoulomb(problem.W, problem.d, frictional(contacts, 0.4), lambda, {}, work);
      EXPECT_TRUE(report.exact) << contacts << " contacts, seed " << seed << ", error " << report.error;
      expectCoulomb(problem, 0.4, lambda, 1e-8);
    }
}

TEST(Coulomb, withoutFrictionItIsTheComplementarityProblem) {
  const Problem problem = randomProblem(12, 60, 7);
  MatX W(12, 12);
  VecX d(12);
  for (int i = 0; i < 12; ++i) {
    d[i] = problem.d[3 * i];
    for (int j = 0; j < 12; ++j) W(i, j) = problem.W(3 * i, 3 * j);
  }
  CoulombWork work;
  LcpWork lcp;
  VecX smooth = VecX::Zero(36), plain = VecX::Zero(12);
  EXPECT_TRUE(solveCoulomb(problem.W, problem.d, frictional(12, 0), smooth, {}, work).exact);
  solveLcp(W, d, plain, {}, lcp);
  for (int i = 0; i < 12; ++i) {
    EXPECT_NEAR(smooth[3 * i], plain[i], 1e-9 * (1 + plain[i]));
    EXPECT_EQ(smooth.segment<2>(3 * i + 1).norm(), 0);
  }
}

TEST(Coulomb, theDirectionsOfTheTangentsDoNotMatter) {
  const Problem problem = randomProblem(6, 30, 3);
  MatX turn = MatX::Identity(18, 18);
  for (int c = 0; c < 6; ++c) turn.block<2, 2>(3 * c + 1, 3 * c + 1) = Eigen::Rotation2Dd(0.3 + c).toRotationMatrix();
  CoulombWork work;
  VecX lambda = VecX::Zero(18), turned = lambda;
  solveCoulomb(problem.W, problem.d, frictional(6, 0.3), lambda, {}, work);
  solveCoulomb(turn * problem.W * turn.transpose(), turn * problem.d, frictional(6, 0.3), turned, {}, work);
  EXPECT_LT((turn * lambda - turned).norm(), 1e-8 * lambda.norm());
}

TEST(Coulomb, aWarmStartDoesNotChangeTheAnswer) {
  const Problem problem = randomProblem(8, 50, 21);
  CoulombWork work;
  VecX cold = VecX::Zero(24), warm = VecX::Constant(24, 2.0);
  solveCoulomb(problem.W, problem.d, frictional(8, 0.3), cold, {}, work);
  solveCoulomb(problem.W, problem.d, frictional(8, 0.3), warm, {}, work);
  EXPECT_LT((cold - warm).norm(), 1e-8 * (1 + cold.norm()));
}

TEST(Coulomb, moreContactsThanDirectionsStayFiniteAndInTheirCones) {
  CoulombWork work;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Problem problem = randomProblem(60, 6, seed);  // sixty contacts of one rigid body
    VecX lambda = VecX::Zero(180);
    const LcpReport report = solveCoulomb(problem.W, problem.d, frictional(60, 0.5), lambda, {}, work);
    ASSERT_TRUE(lambda.allFinite()) << seed;
    const VecX w = problem.W * lambda + problem.d;
    const double scale = problem.d.cwiseAbs().maxCoeff();
    for (int i = 0; i < 180; i += 3) {
      EXPECT_LE(lambda.segment<2>(i + 1).norm(), 0.5 * lambda[i] * (1 + 1e-12) + 1e-15);
      EXPECT_GT(w[i], -(report.exact ? 1e-5 : 2e-2) * scale) << "seed " << seed << " row " << i;
    }
  }
}

TEST(Coulomb, aRowThatNothingAnswersAndANonFiniteGuessAreHarmless) {
  MatX W = MatX::Zero(6, 6);
  W.topLeftCorner<3, 3>().setIdentity();
  VecX lambda = VecX::Constant(6, NAN), d(6);
  d << -1, 0.1, 0, -1, 1, 1;
  CoulombWork work;
  solveCoulomb(W, d, frictional(2, 0.5), lambda, {}, work);
  EXPECT_TRUE(lambda.allFinite());
  EXPECT_NEAR(lambda[0], 1, 1e-10);
  EXPECT_EQ(lambda.tail<3>().norm(), 0);
}

}  // namespace
}  // namespace glenoid
