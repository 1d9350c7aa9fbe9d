// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <limits>
#include <random>

#include "simcore/haptic/LocalProxy.h"
#include "tests/simcore/haptic/Walls.h"

namespace glenoid {
namespace {

using test::handAtHeight;
using test::T;
const ProxyGains kSpring{1000, 0, 2, 0};

TEST(LocalProxy, inTheOpenTheHandFeelsNothing) {
  LocalProxy proxy;
  const LocalProblem problem = test::wall(0, 0.001);
  for (double y = 0.01; y > 0.0; y -= 0.001) EXPECT_LT(proxy.solve(problem, handAtHeight(y), {1000, 0.2, 2, 0}, T, 0).force.norm(), 1e-12);
  EXPECT_LT((proxy.pose(0).p_WB - Vec3(0, 0.001, 0)).norm(), 2e-3);
}

TEST(LocalProxy, againstWhatCannotGiveItFeelsStiffnessTimesDepth) {
  LocalProxy proxy;
  const LocalProblem problem = test::wall();
  for (const double depth : {0.001, 0.004, 0.002}) {
    const ProxyForce felt = proxy.solve(problem, handAtHeight(-depth), kSpring, T, 0);
    EXPECT_LT((felt.force - Vec3(0, 1000 * depth, 0)).norm(), 1e-9);
    EXPECT_NEAR(proxy.pose(0).p_WB.y(), 0, 1e-12);
  }
}

TEST(LocalProxy, againstWhatGivesItFeelsTwoSpringsInARow) {
  LocalProxy proxy;
  const double C = 2e-3;  // 500 N/m
  const ProxyForce felt = proxy.solve(test::wall(C), handAtHeight(-0.003), kSpring, T, 0);
  EXPECT_NEAR(felt.force.y(), 0.003 / (1 / 1000.0 + C), 1e-9);
}

TEST(LocalProxy, atWhatTheSimulationSawItFeelsWhatTheSimulationFelt) {
  // The far side gave way under 1.2 N until the tool rested on it: a hand where it was then must feel that force.
  LocalProblem problem = test::wall(3e-3);
  problem.force[0] = 1.2;
  problem.pose[0].p_WB = Vec3(0, -0.0036, 0);
  LocalProxy proxy;
  EXPECT_NEAR(proxy.solve(problem, handAtHeight(-0.0036 - 1.2 / 1000), kSpring, T, 0).force.y(), 1.2, 1e-9);
}

TEST(LocalProxy, theFarSideGoesOnForTwoStepsAndNoLonger) {
  LocalProblem problem = test::wall();
  problem.approach[0] = -0.1;  // comes at the tool
  for (const auto& [since, expected] : {std::pair{0.0, 0.0}, {0.004, 0.4}, {0.010, 1.0}, {0.5, 1.0}}) {
    LocalProxy proxy;
    EXPECT_NEAR(proxy.solve(problem, handAtHeight(0), kSpring, T, since).force.y(), expected, 1e-9);
  }
}

TEST(LocalProxy, theDamperResistsTheHandAgainstTheToolThatIsHeldUp) {
  LocalProxy proxy;
  const LocalProblem problem = test::wall();
  const ProxyGains gains{1000, 0.5, 2, 0};
  proxy.solve(problem, handAtHeight(-0.001), gains, T, 0);
  EXPECT_NEAR(proxy.solve(problem, handAtHeight(-0.0015), gains, T, 0).force.y(), 1000 * 0.0015 + 0.5 * 0.0005 / T, 1e-9);
}

TEST(LocalProxy, thePullOfAHandIsCutToWhatTheScenarioLetsItPull) {
  LocalProblem problem = test::wall();
  problem.forceMax = 2;
  LocalProxy proxy;
  const ProxyForce felt = proxy.solve(problem, handAtHeight(-0.01), kSpring, T, 0);
  EXPECT_TRUE(felt.cut);
  EXPECT_NEAR(felt.force.norm(), 2, 1e-9);
}

/// The answer by trying every set of rows that press: the one with all signs right.
VecX byEnumeration(const MatX& W, const VecX& d) {
  const int n = static_cast<int>(d.size());
  for (int set = 0; set < 1 << n; ++set) {
    std::vector<int> in;
    for (int i = 0; i < n; ++i)
      if (set >> i & 1) in.push_back(i);
    VecX f = VecX::Zero(n);
    if (!in.empty()) {
      MatX block(in.size(), in.size());
      VecX rhs(in.size());
      for (std::size_t i = 0; i < in.size(); ++i) {
        rhs[static_cast<int>(i)] = -d[in[i]];
        for (std::size_t j = 0; j < in.size(); ++j) block(static_cast<int>(i), static_cast<int>(j)) = W(in[i], in[j]);
      }
      const VecX some = block.fullPivLu().solve(rhs);
      for (std::size_t i = 0; i < in.size(); ++i) f[in[i]] = some[static_cast<int>(i)];
    }
    const VecX w = W * f + d;
    const double tolerance = 1e-9 * d.cwiseAbs().maxCoeff();
    if (f.minCoeff() >= -1e-9 && w.minCoeff() >= -tolerance) return f;
  }
  return VecX::Constant(n, std::numeric_limits<double>::quiet_NaN());
}

/// A tool with a grip far from its centre among rows of all directions, with a far side that gives.
LocalProblem tangle(std::mt19937& random, int rows) {
  std::uniform_real_distribution<double> any(-1, 1);
  LocalProblem problem = test::wall();
  problem.grip_B = Vec3(0.01, -0.02, 0.05);
  problem.pose[0] = {Vec3(0.1, 0.2, -0.1), Quat(1, 0.1, -0.2, 0.3).normalized()};
  problem.rowCount = rows;
  MatX half(rows, rows);
  for (int i = 0; i < rows; ++i) {
    const Vec3 n = Vec3(any(random), any(random), any(random)).normalized(), r = 0.02 * Vec3(any(random), any(random), any(random));
    problem.J.block<1, 3>(i, 0) = n.transpose();
    problem.J.block<1, 3>(i, 3) = r.cross(n).transpose();
    problem.slack[static_cast<std::size_t>(i)] = 0.0003 * (1 + any(random));
    problem.force[static_cast<std::size_t>(i)] = std::max(0.0, any(random));
    for (int j = 0; j < rows; ++j) half(i, j) = 0.02 * any(random);
  }
  problem.C.topLeftCorner(rows, rows) = half * half.transpose();
  return problem;
}

TEST(LocalProxy, itsForcesAreThoseOfTheWholeProblemTriedSetBySet) {
  std::mt19937 random(3);
  std::uniform_real_distribution<double> any(-1, 1);
  for (int round = 0; round < 40; ++round) {
    const int n = 1 + round % 8;
    const LocalProblem problem = tangle(random, n);
    // The tool as the problem has it, then the hand goes 2 mm off.
    LocalProxy proxy;
    LocalProblem open = problem;
    open.rowCount = 0;
    const Pose start{problem.pose[0] * problem.grip_B, problem.pose[0].q_WB};
    proxy.solve(open, start, kSpring, T, 0);
    Pose hand = start;
    hand.p_WB += 0.002 * Vec3(any(random), any(random), any(random));
    proxy.solve(problem, hand, kSpring, T, 0);

    // The same minimum from its definition: A of a spring at the grip and one that turns.
    Eigen::Matrix<double, 3, 6> grip;
    grip << Mat3::Identity(), -skew(problem.pose[0].q_WB * problem.grip_B);
    MatX A = kSpring.stiffness * grip.transpose() * grip;
    A.bottomRightCorner(3, 3) += kSpring.angularStiffness * Mat3::Identity();
    const VecX pull = kSpring.stiffness * grip.transpose() * (hand.p_WB - start.p_WB);
    const MatX J = problem.J.topLeftCorner(n, 6), C = problem.C.topLeftCorner(n, n), inverse = A.inverse();
    VecX d(n), before(n);
    for (int i = 0; i < n; ++i) before[i] = problem.force[static_cast<std::size_t>(i)], d[i] = problem.slack[static_cast<std::size_t>(i)];
    d += J * inverse * pull - C * before;
    const VecX exact = byEnumeration(J * inverse * J.transpose() + C, d);
    ASSERT_TRUE(exact.allFinite()) << round;
    EXPECT_LT((proxy.rowForces().head(n) - exact).norm(), 1e-7 * (1 + exact.norm())) << round;
  }
}

TEST(LocalProxy, aFingerInsideIsCarriedAndFelt) {
  // Two points on a link of 1200 N/m; the inner one lies on what cannot give, the outer one on nothing.
  LocalProblem problem = test::wall();
  problem.bodyCount = 2;
  problem.pose[1].p_WB = Vec3(0, -0.01, 0);
  problem.linkCount = 4;
  const Vec3 ends[] = {{0.01, 0, 0}, {-0.01, 0, 0}, {0, 0.01, 0.03}, {0, -0.01, 0.03}};
  for (int l = 0; l < 4; ++l) problem.links[static_cast<std::size_t>(l)] = {ends[l] + Vec3(0, -0.01, 0), ends[l], 300};
  problem.J.setZero();
  problem.J(0, 7) = 1;
  LocalProxy proxy;
  proxy.solve(problem, handAtHeight(0), {1000, 0, 50, 0}, T, 0);
  ProxyForce felt;
  for (int i = 0; i < 200; ++i) felt = proxy.solve(problem, handAtHeight(-0.002), {1000, 0, 50, 0}, T, 0);
  // The link bends the inner finger about its contact a little beside: softer than the two springs in a row, not by much.
  const double inARow = 0.002 / (1 / 1000.0 + 1 / 1200.0);
  EXPECT_LT(felt.force.y(), inARow * (1 + 1e-9));
  EXPECT_GT(felt.force.y(), 0.3 * inARow);
  EXPECT_NEAR(proxy.rowForces()[0], felt.force.y(), 1e-6);
}

TEST(LocalProxy, whatIsNoHandAndWhatIsNoProblemGiveNoForce) {
  LocalProxy proxy;
  LocalProblem problem = test::wall();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_EQ(proxy.solve(problem, handAtHeight(nan), kSpring, T, 0).force, Vec3(0, 0, 0));
  EXPECT_GT(proxy.solve(problem, handAtHeight(-0.001), kSpring, T, 0).force.norm(), 0.5);
  problem.slack[0] = nan;
  EXPECT_TRUE(proxy.solve(problem, handAtHeight(-0.001), kSpring, T, 0).force.allFinite());
  problem.valid = false;
  EXPECT_EQ(proxy.solve(problem, handAtHeight(-0.001), kSpring, T, 0).force, Vec3(0, 0, 0));
}

TEST(LocalProxy, theLargestProblemIsSolved) {
  std::mt19937 random(11);
  const LocalProblem problem = tangle(random, LocalProblem::kRows);
  LocalProxy proxy;
  const Pose hand{problem.pose[0] * problem.grip_B + Vec3(0.001, -0.002, 0.001), problem.pose[0].q_WB};
  ProxyForce felt;
  for (int i = 0; i < 50; ++i) felt = proxy.solve(problem, hand, kSpring, T, 0);
  EXPECT_TRUE(felt.exact);
  EXPECT_TRUE(felt.force.allFinite());
}

}  // namespace
}  // namespace glenoid
