// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <cstring>
#include <limits>

#include "simcore/linear/BlockCholesky.h"
#include "simcore/linear/Kernels.h"
#include "tests/simcore/linear/Problems.h"

namespace glenoid::test {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

/// ‖b − A x‖ / (‖A‖ ‖x‖ + ‖b‖): a backward stable solver gives a small multiple of the round-off unit
/// whatever the condition number (Higham, "Accuracy and Stability of Numerical Algorithms", ch. 10).
double backwardError(const MatX& A, const VecX& x, const VecX& b) {
  return (b - A * x).norm() / (A.norm() * x.norm() + b.norm());
}

class BlockCholeskyTest : public testing::TestWithParam<bool> {};

}  // namespace

TEST_P(BlockCholeskyTest, solvesAsDenseCholeskyDoes) {
  for (const Pattern& pattern : patterns()) {
    const BlockMatrix A = randomSpd(pattern, 11);
    BlockCholesky cholesky(A.sharedSymbolic(), GetParam());
    ASSERT_TRUE(cholesky.factor(A)) << pattern.name;
    const VecX b = Random(12).vector(3 * pattern.blocks);
    VecX x = b;
    cholesky.solve(x);
    const MatX dense = A.toDense();
    EXPECT_LT(backwardError(dense, x, b), 20 * kEpsilon) << pattern.name;
    const VecX expected = dense.llt().solve(b);
    const double condition = dense.norm() * dense.inverse().norm();
    EXPECT_LT((x - expected).norm(), 20 * kEpsilon * condition * expected.norm()) << pattern.name;
  }
}

TEST_P(BlockCholeskyTest, staysBackwardStableAtConditionTenBillion) {
  for (const Pattern& pattern : patterns()) {
    if (pattern.pairs.size() < 5) continue;  // nothing that could float
    const BlockMatrix A = randomSpd(pattern, 21, 1e-7, 6.0);
    const MatX dense = A.toDense();
    const VecX eigenvalues = Eigen::SelfAdjointEigenSolver<MatX>(dense).eigenvalues();
    const double condition = eigenvalues[eigenvalues.size() - 1] / eigenvalues[0];
    ASSERT_GT(condition, 3e9) << pattern.name;  // otherwise the test tests nothing
    BlockCholesky cholesky(A.sharedSymbolic(), GetParam());
    ASSERT_TRUE(cholesky.factor(A)) << pattern.name;
    const VecX b = Random(22).vector(3 * pattern.blocks);
    VecX x = b;
    cholesky.solve(x);
    EXPECT_LT(backwardError(dense, x, b), 50 * kEpsilon) << pattern.name;
    VecX expected = dense.llt().solve(b);
    EXPECT_LT((x - expected).norm(), 20 * kEpsilon * condition * expected.norm()) << pattern.name;
  }
}

TEST_P(BlockCholeskyTest, solvesThePreparedShoulder) {
  const ShoulderSize problem = shoulderSize();
  BlockCholesky cholesky(problem.symbolic, GetParam());
  ASSERT_TRUE(cholesky.factor(*problem.A));
  const VecX b = Random(5).vector(3 * problem.symbolic->blockCount());
  VecX x = b;
  cholesky.solve(x);
  VecX back;
  problem.A->multiply(x, back);
  EXPECT_LT((b - back).norm(), 50 * kEpsilon * (problem.A->toDense().norm() * x.norm() + b.norm()));
}

TEST_P(BlockCholeskyTest, indefiniteSingularAndNotFiniteAreReported) {
  const double inf = std::numeric_limits<double>::infinity();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Pattern& pattern : patterns()) {
    const BlockMatrix good = randomSpd(pattern, 31);
    BlockCholesky cholesky(good.sharedSymbolic(), GetParam());
    const int n = pattern.blocks;
    for (const int block : {0, n / 2, n - 1}) {
      BlockMatrix A = good;
      const double shift = 1.01 * good.block(block, block)(1, 1);
      A.add(A.symbolic().entry(block, block), Vec3(0, -shift, 0).asDiagonal());
      EXPECT_FALSE(cholesky.factor(A)) << pattern.name << " negative at " << block;
      for (const double bad : {nan, inf, -inf}) {
        A = good;
        A.add(A.symbolic().entry(block, block), Vec3(0, 0, bad).asDiagonal());
        EXPECT_FALSE(cholesky.factor(A)) << pattern.name << ' ' << bad << " at " << block;
      }
    }
    for (const auto& stored : good.symbolic().stored()) {
      if (stored.row == stored.col) continue;
      for (const double bad : {nan, inf}) {
        BlockMatrix A = good;
        A.slot(stored.slot)[9] = bad;
        EXPECT_FALSE(cholesky.factor(A)) << pattern.name << " off-diagonal " << bad;
      }
    }
    BlockMatrix zero(good.sharedSymbolic());
    EXPECT_FALSE(cholesky.factor(zero));
    EXPECT_TRUE(cholesky.factor(good)) << "a failed factorization leaves nothing behind";
    VecX x = VecX::Ones(3 * n);
    cholesky.solve(x);
    EXPECT_TRUE(x.allFinite());
  }
}

TEST_P(BlockCholeskyTest, twoFactorizationsAreBitEqual) {
  const ShoulderSize problem = shoulderSize();
  const VecX b = Random(41).vector(3 * problem.symbolic->blockCount());
  const auto rows = problem.contactRows(33, 42);
  const std::vector<SparseRow> J = asRows(rows);
  std::vector<int> ids(33);
  for (int i = 0; i < 33; ++i) ids[static_cast<std::size_t>(i)] = i;
  VecX x[2] = {b, b};
  MatX W[2] = {MatX::Zero(33, 33), MatX::Zero(33, 33)};
  BlockCholesky reused(problem.symbolic, GetParam());
  BlockMatrix other = *problem.A;
  other.add(other.symbolic().entry(0, 0), Mat3::Identity());
  ASSERT_TRUE(reused.factor(other));  // something else first
  for (int run = 0; run < 2; ++run) {
    BlockCholesky fresh(problem.symbolic, GetParam());
    BlockCholesky& cholesky = run == 0 ? fresh : reused;
    RowPanels panels;
    ASSERT_TRUE(cholesky.factor(*problem.A));
    cholesky.solve(x[run]);
    cholesky.halfSolve(J, panels);
    cholesky.addDelassus(panels, ids, W[run]);
  }
  EXPECT_EQ(std::memcmp(x[0].data(), x[1].data(), sizeof(double) * static_cast<std::size_t>(b.size())), 0);
  EXPECT_EQ(std::memcmp(W[0].data(), W[1].data(), sizeof(double) * 33 * 33), 0);
}

TEST_P(BlockCholeskyTest, paddingLanesDoNotMatter) {
  const BlockMatrix A = randomSpd(patterns().back(), 51);
  BlockMatrix dirty = A;
  for (int s = 0; s < A.symbolic().slotCount(); ++s)
    for (const int lane : {3, 7, 11}) dirty.slot(s)[lane] = 1e3 * s;
  BlockCholesky clean(A.sharedSymbolic(), GetParam()), soiled(A.sharedSymbolic(), GetParam());
  ASSERT_TRUE(clean.factor(A));
  ASSERT_TRUE(soiled.factor(dirty));
  VecX x = VecX::Ones(3 * A.symbolic().blockCount());
  VecX y = x;
  clean.solve(x);
  soiled.solve(y);
  EXPECT_EQ(x, y);
}

INSTANTIATE_TEST_SUITE_P(Kernels, BlockCholeskyTest, testing::Bool(),
                         [](const auto& suite) { return suite.param ? "portable" : "best"; });

TEST(Kernels, portableAndFastAgreeToRoundOff) {
  EXPECT_STREQ(kernelIsaName(true), "portable");
  const ShoulderSize problem = shoulderSize(1.0);
  BlockCholesky fast(problem.symbolic), portable(problem.symbolic, true);
  ASSERT_TRUE(fast.factor(*problem.A));
  ASSERT_TRUE(portable.factor(*problem.A));
  const VecX b = Random(61).vector(3 * problem.symbolic->blockCount());
  VecX x = b, y = b;
  fast.solve(x);
  portable.solve(y);
  // Forward errors: a few round-offs times the condition number (estimated from the two norms).
  const MatX dense = problem.A->toDense();
  const double condition = dense.norm() * dense.inverse().norm();
  EXPECT_LT((x - y).norm(), 10 * kEpsilon * condition * x.norm());
}

TEST(BlockCholesky, emptyMatrixIsFine) {
  const auto symbolic = std::make_shared<const BlockSymbolic>(0, std::span<const std::array<int, 2>>{});
  const BlockMatrix A(symbolic);
  BlockCholesky cholesky(symbolic);
  EXPECT_TRUE(cholesky.factor(A));
  VecX x;
  cholesky.solve(x);
  RowPanels panels;
  cholesky.halfSolve({}, panels);
  EXPECT_EQ(panels.rowCount(), 0);
}

}  // namespace glenoid::test
