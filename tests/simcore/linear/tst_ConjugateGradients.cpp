// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <limits>

#include "simcore/linear/BlockCholesky.h"
#include "simcore/linear/ConjugateGradients.h"
#include "tests/simcore/linear/Problems.h"

namespace glenoid::test {

class ConjugateGradients : public testing::TestWithParam<bool> {};

TEST_P(ConjugateGradients, convergeToTheDirectSolution) {
  for (const Pattern& pattern : patterns()) {
    const BlockMatrix A = randomSpd(pattern, 151);
    BlockCholesky cholesky(A.sharedSymbolic());
    ASSERT_TRUE(cholesky.factor(A));
    const VecX b = Random(152).vector(3 * pattern.blocks);
    VecX expected = b;
    cholesky.solve(expected);
    VecX x = VecX::Zero(b.size());
    CgWork work;
    const CgReport report = solveConjugateGradients(A, b, x, {1e-12, 5000}, work, GetParam());
    EXPECT_TRUE(report.finite);
    EXPECT_FALSE(report.capped) << pattern.name;
    EXPECT_LE(report.residual, 1e-12);
    const MatX dense = A.toDense();
    const double condition = dense.norm() * dense.inverse().norm();
    // ‖x − x*‖ ≤ ‖A⁻¹‖ ‖r‖, so the error is at most cond(A) times the relative residual.
    EXPECT_LT((x - expected).norm(), 2e-12 * condition * expected.norm()) << pattern.name;
  }
}

TEST_P(ConjugateGradients, endInAsManyStepsAsThereAreUnknowns) {
  const BlockMatrix A = randomSpd(patterns()[0], 161, 0.5);
  const VecX b = Random(162).vector(3);
  VecX x = VecX::Zero(3);
  CgWork work;
  const CgReport report = solveConjugateGradients(A, b, x, {1e-10, 50}, work, GetParam());
  EXPECT_LE(report.iterations, 3);
  EXPECT_FALSE(report.capped);
}

TEST_P(ConjugateGradients, goodGuessCostsNothingAndZeroGivesZero) {
  const BlockMatrix A = randomSpd(patterns()[6], 171);
  const int size = 3 * A.symbolic().blockCount();
  const VecX exact = Random(172).vector(size);
  VecX b;
  A.multiply(exact, b);
  VecX x = exact;
  CgWork work;
  EXPECT_EQ(solveConjugateGradients(A, b, x, {1e-10, 50}, work, GetParam()).iterations, 0);
  EXPECT_EQ(x, exact);
  x = VecX::Zero(size);
  const CgReport report = solveConjugateGradients(A, VecX::Zero(size), x, {1e-10, 50}, work, GetParam());
  EXPECT_EQ(report.iterations, 0);
  EXPECT_TRUE(report.finite);
  EXPECT_EQ(x.norm(), 0.0);
}

TEST_P(ConjugateGradients, capIsReported) {
  const ShoulderSize problem = shoulderSize();
  const int size = 3 * problem.symbolic->blockCount();
  VecX x = VecX::Zero(size);
  CgWork work;
  const CgReport report =
      solveConjugateGradients(*problem.A, Random(181).vector(size), x, {1e-12, 7}, work, GetParam());
  EXPECT_TRUE(report.capped);
  EXPECT_TRUE(report.finite);
  EXPECT_EQ(report.iterations, 7);
  EXPECT_GT(report.residual, 1e-12);
}

TEST_P(ConjugateGradients, badNumbersLeaveTheGuessAlone) {
  const BlockMatrix good = randomSpd(patterns()[2], 191);
  const int size = 3 * good.symbolic().blockCount();
  const VecX guess = Random(192).vector(size);
  const VecX b = Random(193).vector(size);
  CgWork work;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  BlockMatrix A = good;
  A.add(A.symbolic().entry(1, 1), nan * Mat3::Identity());
  VecX x = guess;
  EXPECT_FALSE(solveConjugateGradients(A, b, x, {1e-8, 100}, work, GetParam()).finite);
  EXPECT_EQ(x, guess);
  VecX badB = b;
  badB[4] = nan;
  EXPECT_FALSE(solveConjugateGradients(good, badB, x, {1e-8, 100}, work, GetParam()).finite);
  EXPECT_EQ(x, guess);
  A = good;
  for (int i = 0; i < size / 3; ++i) A.add(A.symbolic().entry(i, i), -1e3 * Mat3::Identity());
  const CgReport negative = solveConjugateGradients(A, b, x, {1e-8, 100}, work, GetParam());
  EXPECT_FALSE(negative.finite);
  EXPECT_EQ(x, guess);
}

INSTANTIATE_TEST_SUITE_P(Preconditioner, ConjugateGradients, testing::Bool(),
                         [](const auto& suite) { return suite.param ? "blockJacobi" : "plain"; });

TEST(ConjugateGradients, preconditionerPaysOnMixedStiffness) {
  const ShoulderSize problem = shoulderSize();
  const int size = 3 * problem.symbolic->blockCount();
  const VecX b = Random(201).vector(size);
  CgWork work;
  VecX x = VecX::Zero(size), y = x;
  const CgReport plain = solveConjugateGradients(*problem.A, b, x, {1e-6, 20000}, work, false);
  const CgReport jacobi = solveConjugateGradients(*problem.A, b, y, {1e-6, 20000}, work, true);
  EXPECT_FALSE(plain.capped || jacobi.capped);
  EXPECT_LT(jacobi.iterations, plain.iterations);
}

TEST(LambdaMax, isTheLargestGeneralizedEigenvalue) {
  for (const Pattern& pattern : patterns()) {
    const BlockMatrix A = randomSpd(pattern, 211);
    const MatX dense = A.toDense();
    MatX D = MatX::Zero(dense.rows(), dense.cols());
    for (int i = 0; i < pattern.blocks; ++i) D.block<3, 3>(3 * i, 3 * i) = dense.block<3, 3>(3 * i, 3 * i);
    const Eigen::LLT<MatX> inverse(D);
    const double exact = Eigen::GeneralizedSelfAdjointEigenSolver<MatX>(dense, D).eigenvalues().maxCoeff();
    PowerWork work;
    const auto apply = [&](VecX& x) { x = inverse.solve(x).eval(); };
    const double estimate = estimateLambdaMax(A, apply, 200, work);
    // From below (round-off apart), and power iteration needs long only where the next eigenvalue is as good.
    EXPECT_LT(estimate, exact * (1 + 1e-12)) << pattern.name;
    EXPECT_GT(estimate, exact * 0.98) << pattern.name;
    VecX last;
    EXPECT_EQ(estimateLambdaMax(A, apply, 200, last), estimate) << "deterministic";
  }
}

TEST(LambdaMax, ofScaledIdentityAndBadNumbers) {
  const Pattern pattern{"one", 2, {}};
  BlockMatrix A = randomSpd(pattern, 221, 3.0);
  PowerWork work;
  EXPECT_NEAR(estimateLambdaMax(
                  A, [](VecX&) {}, 3, work),
              3.0, 1e-14);
  A.add(A.symbolic().entry(0, 0), std::numeric_limits<double>::infinity() * Mat3::Identity());
  EXPECT_TRUE(std::isnan(estimateLambdaMax(
      A, [](VecX&) {}, 3, work)));
}

}  // namespace glenoid::test
