// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <random>

#include "simcore/contact/ActiveSet.h"
#include "simcore/contact/Lcp.h"

namespace glenoid {
namespace {

struct Problem {
  MatX W;
  VecX d;
};

/// W = Yᵀ Y with `rank` rows, so more contacts than directions make it singular; row i has its own scale.
Problem randomProblem(int n, int rank, unsigned seed) {
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const MatX Y = MatX::NullaryExpr(rank, n, [&] { return normal(random); });
  VecX scale(n);
  for (int i = 0; i < n; ++i) scale[i] = std::pow(10.0, i % 4 - 2);
  Problem problem;
  problem.W = scale.asDiagonal() * (Y.transpose() * Y) * scale.asDiagonal();
  // d = Yᵀ u is in the range: a solution exists however low the rank.
  problem.d = scale.asDiagonal() * (Y.transpose() * VecX::NullaryExpr(rank, [&] { return normal(random); }));
  return problem;
}

void expectComplementary(const Problem& problem, const VecX& lambda, double tolerance) {
  const VecX w = problem.W * lambda + problem.d;
  for (Eigen::Index i = 0; i < w.size(); ++i) {
    const double scale = std::sqrt(problem.W(i, i));
    EXPECT_GE(lambda[i], 0);
    EXPECT_GT(w[i], -tolerance * scale) << i;
    EXPECT_LT(std::min(lambda[i] * problem.W(i, i), w[i]), tolerance * scale) << i;
  }
}

TEST(Lcp, oneRowInClosedForm) {
  LcpWork work;
  VecX lambda = VecX::Zero(1);
  const MatX W = MatX::Constant(1, 1, 4);
  EXPECT_TRUE(solveLcp(W, VecX::Constant(1, -2), lambda, {}, work).exact);
  EXPECT_NEAR(lambda[0], 0.5, 1e-11);
  solveLcp(W, VecX::Constant(1, 2), lambda, {}, work);
  EXPECT_EQ(lambda[0], 0);
}

TEST(Lcp, exactOnRandomDefiniteProblems) {
  LcpWork work;
  for (const int n : {2, 7, 30, 90}) {
    const Problem problem = randomProblem(n, 2 * n, n);
    VecX lambda = VecX::Zero(n);
    const LcpReport report = solveLcp(problem.W, problem.d, lambda, {}, work);
    EXPECT_TRUE(report.exact) << n;
    expectComplementary(problem, lambda, 1e-8);
  }
}

TEST(Lcp, pgsAloneConvergesToTheSameAnswer) {
  LcpWork work;
  const Problem problem = randomProblem(12, 40, 5);
  VecX exact = VecX::Zero(12), slow = exact;
  solveLcp(problem.W, problem.d, exact, {}, work);
  LcpLimits limits;
  limits.pivots = 0;
  limits.sweeps = 5000;
  solveLcp(problem.W, problem.d, slow, limits, work);
  for (int i = 0; i < 12; ++i) EXPECT_NEAR(slow[i], exact[i], 1e-8 * (1 + exact[i]));
}

TEST(Lcp, duplicatesAreMendedByCompliance) {
  Problem problem = randomProblem(6, 20, 9);
  MatX W(12, 12);
  VecX d(12);
  for (int i = 0; i < 12; ++i) {
    d[i] = problem.d[i % 6];
    for (int j = 0; j < 12; ++j) W(i, j) = problem.W(i % 6, j % 6);
  }
  LcpWork work;
  VecX lambda = VecX::Zero(12);
  solveLcp(W, d, lambda, {}, work);
  expectComplementary({W, d}, lambda, 1e-6);
}

TEST(Lcp, moreContactsThanDirectionsStayFiniteAndFeasible) {
  LcpWork work;
  for (unsigned seed = 0; seed < 20; ++seed) {
    const Problem problem = randomProblem(40, 6, seed);  // forty contacts between two rigid bodies
    VecX lambda = VecX::Zero(40);
    const LcpReport report = solveLcp(problem.W, problem.d, lambda, {}, work);
    ASSERT_TRUE(lambda.allFinite());
    expectComplementary(problem, lambda, report.exact ? 1e-5 : 1e-2);
  }
}

TEST(Lcp, hundredsOfRowsOnFewDirectionsAreExact) {
  LcpWork work;
  for (const int rank : {6, 30, 90})
    for (unsigned seed = 0; seed < 5; ++seed) {
      const Problem problem = randomProblem(300, rank, seed);
      VecX lambda = VecX::Zero(300);
      const LcpReport report = solveLcp(problem.W, problem.d, lambda, {}, work);
      EXPECT_TRUE(report.exact) << rank << ", " << seed;
      expectComplementary(problem, lambda, 1e-6);
    }
}

TEST(ActiveSet, takesInWhatCarriesAndExchangesWhatDepends) {
  for (const int rank : {1, 6, 30, 90})
    for (unsigned seed = 0; seed < 10; ++seed) {
      const int n = 300;
      const Problem problem = randomProblem(n, rank, seed);
      LcpWork work;
      work.scaled = work.factor = MatX::Zero(n + 1, n + 1);
      for (VecX* vector : {&work.d, &work.lambda, &work.w, &work.rhs, &work.cosine, &work.sine}) vector->setZero(n + 1);
      work.active.resize(n + 1);
      work.isActive.resize(n + 1);
      const VecX scale = problem.W.diagonal().cwiseSqrt().cwiseInverse();
      work.scaled.topLeftCorner(n, n) = scale.asDiagonal() * problem.W * scale.asDiagonal();
      work.d.head(n) = scale.asDiagonal() * problem.d;
      int steps = 0;
      EXPECT_TRUE(activeSet(work, n, 1e-9, 20 + 3 * n, steps)) << rank << ", " << seed;
      const VecX w = work.scaled.topLeftCorner(n, n) * work.lambda.head(n) + work.d.head(n);
      for (int i = 0; i < n; ++i) {
        EXPECT_GE(work.lambda[i], 0);
        EXPECT_GT(w[i], -1e-8);
        EXPECT_LT(std::min(work.lambda[i], w[i]), 1e-8);
      }
      EXPECT_LE((work.lambda.head(n).array() > 0).count(), rank) << "no more rows carry than there are directions";
      EXPECT_LT(steps, 20 + 6 * rank);
    }
}

TEST(ActiveSet, rowsThatContradictEachOtherAreSaid) {
  // Two that press a body from both sides, each asking it to leave.
  LcpWork work;
  work.scaled = work.factor = MatX::Identity(3, 3);
  work.scaled(0, 1) = work.scaled(1, 0) = -1;
  for (VecX* vector : {&work.d, &work.lambda, &work.w, &work.rhs, &work.cosine, &work.sine}) vector->setZero(3);
  work.d << -1, -2, 0;
  work.active.resize(3);
  work.isActive.resize(3);
  int steps = 0;
  EXPECT_FALSE(activeSet(work, 2, 1e-12, 26, steps));
  EXPECT_LE(steps, 26);
  EXPECT_TRUE(work.lambda.allFinite());
}

TEST(Lcp, oneMotionThatManyRowsAskForIsFoundAtOnce) {
  // A body pushed along one way by 200 rows at its mass centre, which ask for different speeds: the greatest is met.
  LcpWork work;
  const MatX W = MatX::Constant(200, 200, 2.0);
  VecX d(200), lambda = VecX::Zero(200);
  for (int i = 0; i < 200; ++i) d[i] = -0.1 - 1e-4 * ((37 * i) % 200);
  const LcpReport report = solveLcp(W, d, lambda, {}, work);
  EXPECT_TRUE(report.exact);
  EXPECT_NEAR(2 * lambda.sum(), 0.1 + 1e-4 * 199, 1e-9);
}

TEST(Lcp, fewStepsAreKeptTo) {
  const Problem problem = randomProblem(300, 30, 3);
  LcpWork work;
  VecX lambda = VecX::Zero(300);
  LcpLimits limits;
  limits.stepsMost = 4;
  const LcpReport report = solveLcp(problem.W, problem.d, lambda, limits, work);
  EXPECT_LE(report.pivots, 4);
  EXPECT_TRUE(lambda.allFinite());
  EXPECT_GE(lambda.minCoeff(), 0);
}

TEST(Lcp, warmStartDoesNotChangeTheAnswer) {
  LcpWork work;
  const Problem problem = randomProblem(25, 60, 11);
  VecX cold = VecX::Zero(25), warm = VecX::Constant(25, 3.0);
  solveLcp(problem.W, problem.d, cold, {}, work);
  solveLcp(problem.W, problem.d, warm, {}, work);
  for (int i = 0; i < 25; ++i) EXPECT_NEAR(warm[i], cold[i], 1e-9 * (1 + cold[i]));
}

TEST(Lcp, notFiniteGuessIsDropped) {
  LcpWork work;
  VecX lambda = VecX::Constant(1, NAN);
  solveLcp(MatX::Identity(1, 1), VecX::Constant(1, -1), lambda, {}, work);
  EXPECT_NEAR(lambda[0], 1, 1e-11);
}

}  // namespace
}  // namespace glenoid
