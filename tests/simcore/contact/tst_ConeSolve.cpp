// SPDX-License-Identifier: GPL-3.0-or-later
// The two systems behind the friction solve and what it is made of, each against dense linear algebra.
#include <gtest/gtest.h>

#include <Eigen/LU>
#include <random>

#include "simcore/contact/ConeIteration.h"
#include "simcore/contact/ImpulseSystem.h"
#include "simcore/contact/VelocitySystem.h"

namespace glenoid {
namespace {

/// A chain of point masses with stiff links, as a soft body is: A = M + Δt² K over `blocks` nodes, and contacts that push
/// single nodes, or two at a time where `across` > 0, along random directions.
struct Chain {
  std::shared_ptr<const BlockSymbolic> symbolic;
  std::unique_ptr<BlockMatrix> A;
  std::unique_ptr<ImpulseResponse> response;
  VecX b, v;
  std::vector<std::vector<RowTerm>> terms;
  std::vector<SparseRow> rows;
  std::vector<int> ids;
  std::vector<ContactUnknowns> contacts;
  VecX d;

  Chain(int blocks, int count, double stiffness, double mu, unsigned seed, int across = 0) {
    std::vector<std::array<int, 2>> pairs;
    for (int i = 1; i < blocks; ++i) pairs.push_back({i, i - 1});
    symbolic = std::make_shared<BlockSymbolic>(blocks, pairs);
    A = std::make_unique<BlockMatrix>(symbolic);
    A->setZero();
    const Mat3 link = stiffness * Vec3(1, 0.3, 0.2).asDiagonal();
    for (int i = 0; i < blocks; ++i) {
      A->add(symbolic->entry(i, i), Mat3::Identity() + (i > 0 ? 1 : 0) * link + (i + 1 < blocks ? 1 : 0) * link);
      if (i > 0) A->add(symbolic->entry(i, i - 1), -link);
    }
    response = makeCholeskyResponse(symbolic, true);
    EXPECT_TRUE(response->factor(*A));
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    b = VecX::NullaryExpr(3 * blocks, [&] { return normal(random); });
    v = VecX::Zero(3 * blocks);
    d = VecX::Zero(3 * count);
    for (int c = 0; c < count; ++c) {
      contacts.push_back({3 * c, true, mu});
      const Vec3 n = Vec3(normal(random), normal(random), normal(random)).normalized(), t = n.unitOrthogonal();
      const int block = static_cast<int>(random() % static_cast<unsigned>(blocks - across));
      for (const Vec3& direction : {n, t, Vec3(n.cross(t))}) {
        std::vector<RowTerm> row{{block, direction}};
        if (across > 0) row.push_back({block + across, -0.5 * direction});
        terms.push_back(row);
        ids.push_back(static_cast<int>(ids.size()));
      }
    }
    for (const auto& row : terms) rows.emplace_back(row);
  }
  /// The chain as the whole problem of `system`, whose calls it has to outlive.
  void into(VelocitySystem& system) {
    islands = {island()};
    compliance.assign(contacts.size(), 0.0);
    system.set(islands, contacts, compliance, d);
  }
  std::vector<VelocityIsland> islands;
  std::vector<double> compliance;
  VelocityIsland island() { return {A.get(), &b, response.get(), rows, ids, &v}; }
  MatX jacobian() const {
    MatX J = MatX::Zero(static_cast<Eigen::Index>(rows.size()), b.size());
    for (std::size_t r = 0; r < rows.size(); ++r)
      for (const RowTerm& term : rows[r]) J.row(static_cast<Eigen::Index>(r)).segment<3>(3 * term.block) += term.coefficient.transpose();
    return J;
  }
  MatX delassus() const { return jacobian() * A->toDense().inverse() * jacobian().transpose(); }
};

TEST(VelocitySystem, answersAsTheImpulseSystemDoes) {
  for (const unsigned seed : {1u, 2u, 3u, 4u}) {
    Chain chain(12, 8, 30, 0.4, seed);
    ConeLimits limits;
    limits.tolerance = limits.enough = 1e-11;
    ConeWork work;
    VelocitySystem velocities(true);
    chain.into(velocities);
    VecX lambda = VecX::Zero(24);
    ASSERT_TRUE(solveCones(velocities, lambda, limits, work).exact) << seed;
    const MatX J = chain.jacobian(), W = chain.delassus();
    const VecX free = J * chain.A->toDense().inverse() * chain.b;
    EXPECT_LT((chain.A->toDense() * chain.v - chain.b - J.transpose() * lambda).norm(), 1e-9) << "momentum";
    ImpulseSystem impulses;
    impulses.set(W, free, chain.contacts, 0);
    VecX other = VecX::Zero(24);
    ASSERT_TRUE(solveCones(impulses, other, limits, work).exact) << seed;
    EXPECT_LT((J * chain.v - (W * other + free)).cwiseAbs().maxCoeff(), 1e-8) << "speeds at the contacts, seed " << seed;
    EXPECT_GT(lambda.cwiseAbs().maxCoeff(), 0.1) << "something presses";
  }
}

TEST(VelocitySystem, knowsWhatStiffTissueAnswers) {
  // One node of a stiff chain takes all others along: the block alone would say a hundredth of the truth.
  Chain chain(20, 10, 1e3, 0.4, 7);
  VelocitySystem velocities(true);
  chain.into(velocities);
  const MatX W = chain.delassus();
  for (int c = 0; c < 10; ++c) {
    const double truth = W.block<3, 3>(3 * c, 3 * c).diagonal().maxCoeff();
    EXPECT_GT(velocities.answer(c), 0.1 * truth) << c;
    EXPECT_LT(velocities.answer(c), 10 * truth) << c;
  }
}

TEST(VelocitySystem, keepsItsPatternWhileContactsStayWithinIt) {
  VelocitySystem velocities(true);
  Chain near(12, 6, 10, 0.3, 1, 1), far(12, 6, 10, 0.3, 1, 5);
  near.into(velocities);
  EXPECT_TRUE(velocities.renewed());
  near.into(velocities);
  EXPECT_FALSE(velocities.renewed()) << "neighbours in the chain are joined already";
  // Rows of the other chain over the first one's matrix: they join nodes that nothing joined.
  const std::vector<VelocityIsland> islands{{near.A.get(), &near.b, near.response.get(), far.rows, far.ids, &near.v}};
  velocities.set(islands, far.contacts, near.compliance, far.d);
  EXPECT_TRUE(velocities.renewed());
}

TEST(VelocitySystem, anImpulseOutOfBalanceIsSeen) {
  Chain chain(6, 2, 5, 0.3, 3);
  VelocitySystem velocities(true);
  chain.into(velocities);
  VecX lambda = VecX::Zero(6), w(6);
  lambda[0] = 0.5;
  velocities.begin(lambda, w);
  EXPECT_LT(velocities.imbalance(lambda), 1e-12);
  lambda[0] = 0.6;
  EXPECT_GT(velocities.imbalance(lambda), 0.1 * 0.1 * chain.delassus()(0, 0)) << "a tenth of what 0.1 N·s does there";
}

TEST(ConeIteration, theErrorIsTheWorstContactsOwn) {
  const MatX W = MatX::Identity(6, 6);
  const std::vector<ContactUnknowns> contacts{{0, true, 0.5}, {3, true, 0.5}};
  VecX d(6);
  d << -1, 0, 0, 0.25, 0, 0;
  ImpulseSystem system;
  system.set(W, d, contacts, 0);
  ConeWork work;
  work.lambda0 = work.w = VecX::Zero(6);
  work.weight = {1, 1};
  work.ranks = {-1, -1};
  work.points.resize(2);
  ConeIteration iteration{system, work, contacts, 6};
  VecX lambda = VecX::Zero(6);
  system.begin(lambda, work.w);
  EXPECT_DOUBLE_EQ(iteration.errorOf(0, lambda), 1) << "approaches at 1 m/s";
  EXPECT_DOUBLE_EQ(iteration.errorOf(1, lambda), 0) << "opens";
  EXPECT_DOUBLE_EQ(iteration.error(lambda), 1);
  lambda[0] = 1;
  system.begin(lambda, work.w);
  EXPECT_NEAR(iteration.error(lambda), 0, 1e-15);
  work.points[0].rank = 3;
  work.points[1].rank = 0;
  EXPECT_FALSE(iteration.sameRanks());
  EXPECT_TRUE(iteration.sameRanks());
  work.points[1].rank = 2;
  EXPECT_FALSE(iteration.sameRanks());
}

TEST(KrylovSolve, solvesWhatADenseSolveSolves) {
  std::mt19937 random(5);
  std::normal_distribution<double> normal;
  for (const int size : {1, 3, 20, 39}) {
    const MatX T = 0.5 / std::sqrt(size) * MatX::NullaryExpr(size, size, [&] { return normal(random); });
    const VecX e = VecX::NullaryExpr(size, [&] { return normal(random); });
    const VecX exact = (MatX::Identity(size, size) - T).partialPivLu().solve(e);
    VecX x = e;
    KrylovWork work;
    int products = 0;
    solveShifted(
        [&](const VecX& in, VecX& out) {
          out.head(size) = T * in.head(size);
          ++products;
        },
        size, 1e-12, x, work);
    EXPECT_LT((x - exact).norm(), 1e-10 * exact.norm()) << size;
    EXPECT_LE(products, size + 1) << "each direction once";
  }
}

TEST(KrylovSolve, nothingAskedIsNothingAnswered) {
  VecX x = VecX::Zero(4);
  KrylovWork work;
  solveShifted([](const VecX&, VecX&) { FAIL() << "no product is needed"; }, 4, 1e-3, x, work);
  EXPECT_EQ(x, VecX::Zero(4));
}

// Fifty boxes' worth of rigid rows: dependent, with no impulses that a small change would not replace. What ends is right.
TEST(ConeSolve, aBodyOnMoreContactsThanItHasUnknownsSettles) {
  std::mt19937 random(9);
  std::uniform_real_distribution<double> place(-1, 1);
  int unsettled = 0;
  for (int run = 0; run < 50; ++run) {
    const int count = 6 + run % 20;
    MatX J = MatX::Zero(3 * count, 6);
    std::vector<ContactUnknowns> contacts;
    for (int c = 0; c < count; ++c) {
      const Vec3 at(place(random), -0.2, place(random));
      contacts.push_back({3 * c, true, 0.4});
      const std::array<Vec3, 3> directions{Vec3::UnitY(), Vec3::UnitX(), Vec3::UnitZ()};
      for (int k = 0; k < 3; ++k) J.row(3 * c + k) << directions[k].transpose(), at.cross(directions[k]).transpose();
    }
    const MatX W = J * J.transpose();
    VecX v(6);
    v << 0.1 * place(random), -1, 0.1 * place(random), place(random), place(random), place(random);
    ImpulseSystem system;
    const VecX d = J * v;
    system.set(W, d, contacts, 1e-12);
    ConeLimits limits;
    limits.tolerance = limits.enough = 1e-10;
    ConeWork work;
    VecX lambda = VecX::Zero(3 * count);
    const LcpReport report = solveCones(system, lambda, limits, work);
    unsettled += !report.exact;
    const VecX w = W * lambda + d;
    for (int c = 0; c < count; ++c) {
      EXPECT_GE(lambda[3 * c], 0);
      EXPECT_LE(lambda.segment<2>(3 * c + 1).norm(), 0.4 * lambda[3 * c] * (1 + 1e-12));
      if (report.exact) {
        EXPECT_LT(coulombError(lambda.segment<3>(3 * c), w.segment<3>(3 * c), 0.4, W(3 * c, 3 * c)), 1e-8);
      }
    }
  }
  std::printf("%d of 50 do not settle to 1e-10\n", unsettled);
  EXPECT_LE(unsettled, 1);
}

}  // namespace
}  // namespace glenoid
