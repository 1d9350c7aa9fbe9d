// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <limits>
#include <numeric>

#include "simcore/linear/BlockCholesky.h"
#include "tests/simcore/linear/Problems.h"

namespace glenoid::test {
namespace {

constexpr double kEpsilon = std::numeric_limits<double>::epsilon();

class Delassus : public testing::TestWithParam<bool> {};

std::vector<int> ascending(int count, int first = 0) {
  std::vector<int> ids(static_cast<std::size_t>(count));
  std::iota(ids.begin(), ids.end(), first);
  return ids;
}

}  // namespace

TEST_P(Delassus, isThatOfTheDenseInverse) {
  RowPanels panels;  // one for all: reuse must not leave anything behind
  for (const Pattern& pattern : patterns()) {
    const BlockMatrix A = randomSpd(pattern, 71);
    const MatX dense = A.toDense();
    const double condition = dense.norm() * dense.inverse().norm();
    BlockCholesky cholesky(A.sharedSymbolic(), GetParam());
    ASSERT_TRUE(cholesky.factor(A));
    for (const int count : {0, 1, 3, 4, 5, 8, 9, 29}) {
      const auto rows = randomRows(pattern.blocks, count, 6, static_cast<unsigned>(80 + count));
      const MatX J = denseRows(rows, pattern.blocks);
      cholesky.halfSolve(asRows(rows), panels);
      ASSERT_EQ(panels.rowCount(), count);
      MatX W = MatX::Zero(count, count);
      cholesky.addDelassus(panels, ascending(count), W);
      const MatX expected = J * dense.llt().solve(MatX(J.transpose()));
      EXPECT_LE((W - expected).norm(), 20 * kEpsilon * condition * expected.norm()) << pattern.name << count;
      EXPECT_EQ(W, MatX(W.transpose())) << "exactly symmetric";
    }
  }
}

TEST_P(Delassus, rowIdsScatterAndAccumulate) {
  const Pattern pattern = patterns()[6];
  const BlockMatrix A = randomSpd(pattern, 91);
  BlockCholesky cholesky(A.sharedSymbolic(), GetParam());
  ASSERT_TRUE(cholesky.factor(A));
  const auto rows = randomRows(pattern.blocks, 11, 5, 92);
  RowPanels panels;
  cholesky.halfSolve(asRows(rows), panels);
  MatX plain = MatX::Zero(11, 11);
  cholesky.addDelassus(panels, ascending(11), plain);
  std::vector<int> ids;
  for (int i = 0; i < 11; ++i) ids.push_back(2 * ((i * 7) % 11) + 3);
  const MatX before = MatX::Random(30, 30);
  MatX W = before;
  cholesky.addDelassus(panels, ids, W);
  MatX expected = before;
  for (int i = 0; i < 11; ++i)
    for (int j = 0; j < 11; ++j)
      expected(ids[static_cast<std::size_t>(i)], ids[static_cast<std::size_t>(j)]) += plain(i, j);
  EXPECT_EQ(W, expected);
}

TEST_P(Delassus, impulsesAreAnsweredByTheInverse) {
  for (const Pattern& pattern : patterns()) {
    const BlockMatrix A = randomSpd(pattern, 101);
    const MatX dense = A.toDense();
    const double condition = dense.norm() * dense.inverse().norm();
    BlockCholesky cholesky(A.sharedSymbolic(), GetParam());
    ASSERT_TRUE(cholesky.factor(A));
    for (const int count : {1, 6, 21}) {
      const auto rows = randomRows(pattern.blocks, count, 4, static_cast<unsigned>(110 + count));
      const MatX J = denseRows(rows, pattern.blocks);
      RowPanels panels;
      cholesky.halfSolve(asRows(rows), panels);
      VecX lambda = Random(120).vector(count);
      if (count > 12) lambda.segment(3, 9).setZero();  // inactive contacts
      const VecX before = Random(121).vector(3 * pattern.blocks);
      VecX v = before;
      cholesky.addImpulses(panels, {lambda.data(), static_cast<std::size_t>(count)}, v);
      const VecX response = dense.llt().solve(J.transpose() * lambda);
      EXPECT_LT((v - before - response).norm(), 20 * kEpsilon * condition * (response.norm() + before.norm()))
          << pattern.name << count;
    }
  }
}

TEST_P(Delassus, rowsOfDisconnectedGraphsDoNotMeet) {
  const Pattern pattern{"two", 2, {}};
  const BlockMatrix A = randomSpd(pattern, 131, 2.0);
  BlockCholesky cholesky(A.sharedSymbolic(), GetParam());
  ASSERT_TRUE(cholesky.factor(A));
  const std::vector<std::vector<RowTerm>> rows{{{0, Vec3::UnitX()}}, {{1, Vec3::UnitX()}}};
  RowPanels panels;
  cholesky.halfSolve(asRows(rows), panels);
  MatX W = MatX::Zero(2, 2);
  cholesky.addDelassus(panels, ascending(2), W);
  EXPECT_EQ(W(0, 1), 0.0);
  EXPECT_NEAR(W(0, 0), 0.5, 2 * kEpsilon);
}

TEST_P(Delassus, halfSolvesStayWithinReach) {
  const ShoulderSize problem = shoulderSize();
  BlockCholesky cholesky(problem.symbolic, GetParam());
  ASSERT_TRUE(cholesky.factor(*problem.A));
  const std::vector<std::vector<RowTerm>> rows{{{problem.symbolic->blockAt(0), Vec3::UnitY()}}};
  RowPanels panels;
  cholesky.halfSolve(asRows(rows), panels);
  EXPECT_EQ(panels.storedBlocks(), problem.symbolic->depths()[0] + 1) << "one way to the root";
}

INSTANTIATE_TEST_SUITE_P(Kernels, Delassus, testing::Bool(),
                         [](const auto& suite) { return suite.param ? "portable" : "best"; });

TEST(Delassus, rowsWithoutTermsGiveZero) {
  const BlockMatrix A = randomSpd(patterns()[2], 141);
  BlockCholesky cholesky(A.sharedSymbolic());
  ASSERT_TRUE(cholesky.factor(A));
  const std::vector<std::vector<RowTerm>> rows{{}, {{3, Vec3::UnitX()}}, {}};
  RowPanels panels;
  cholesky.halfSolve(asRows(rows), panels);
  MatX W = MatX::Zero(3, 3);
  cholesky.addDelassus(panels, ascending(3), W);
  EXPECT_EQ(W(0, 0), 0.0);
  EXPECT_EQ(W(0, 1), 0.0);
  EXPECT_GT(W(1, 1), 0.0);
}

}  // namespace glenoid::test
