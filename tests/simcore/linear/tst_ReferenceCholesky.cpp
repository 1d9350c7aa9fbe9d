// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/linear/ReferenceCholesky.h"

#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <limits>

#include "simcore/linear/BlockCholesky.h"
#include "tests/simcore/linear/Problems.h"

namespace glenoid::test {

class ReferenceCholeskyTest : public testing::TestWithParam<ReferenceCholesky::Method> {};

TEST_P(ReferenceCholeskyTest, agreesWithDenseOnEveryPattern) {
  for (const Pattern& pattern : patterns()) {
    const BlockMatrix A = randomSpd(pattern, 231);
    ReferenceCholesky reference(A.sharedSymbolic(), GetParam());
    ASSERT_TRUE(reference.factor(A)) << pattern.name;
    const VecX b = Random(232).vector(3 * pattern.blocks);
    VecX x = b;
    reference.solve(x);
    const MatX dense = A.toDense();
    const VecX expected = dense.cast<long double>().llt().solve(b.cast<long double>()).cast<double>();
    // Refined with extended residuals: correct to the last places, whatever the condition.
    EXPECT_LT((x - expected).norm(), 1e-15 * expected.norm()) << pattern.name;
  }
}

TEST_P(ReferenceCholeskyTest, agreesWithOursOnTheShoulder) {
  const ShoulderSize problem = shoulderSize();
  ReferenceCholesky reference(problem.symbolic, GetParam());
  BlockCholesky own(problem.symbolic);
  BlockMatrix A = *problem.A;
  for (int step = 0; step < 3; ++step) {  // the symbolic phase is reused
    ASSERT_TRUE(reference.factor(A));
    ASSERT_TRUE(own.factor(A));
    VecX x = Random(240).vector(3 * problem.symbolic->blockCount());
    VecX y = x;
    reference.solve(x);
    own.solve(y);
    // Condition up to about 1e8 here, so eight digits of sixteen are safe for the unrefined solve.
    EXPECT_LT((x - y).norm(), 1e-8 * x.norm());
    A.add(A.symbolic().entry(step, step), Mat3::Identity());
  }
}

TEST_P(ReferenceCholeskyTest, reportsWhatCannotBeFactored) {
  const BlockMatrix good = randomSpd(patterns()[6], 251);
  ReferenceCholesky reference(good.sharedSymbolic(), GetParam());
  BlockMatrix A = good;
  A.add(A.symbolic().entry(5, 5), -1e3 * Mat3::Identity());
  EXPECT_FALSE(reference.factor(A));
  A = good;
  A.add(A.symbolic().entry(5, 5), std::numeric_limits<double>::quiet_NaN() * Mat3::Identity());
  EXPECT_FALSE(reference.factor(A));
  ASSERT_TRUE(reference.factor(good)) << "a failure leaves nothing behind";
  VecX x = VecX::Ones(3 * good.symbolic().blockCount());
  reference.solve(x);
  EXPECT_TRUE(x.allFinite());
}

INSTANTIATE_TEST_SUITE_P(Methods, ReferenceCholeskyTest,
                         testing::Values(ReferenceCholesky::Method::Automatic,
                                         ReferenceCholesky::Method::Simplicial,
                                         ReferenceCholesky::Method::Supernodal));

TEST(ReferenceCholesky, emptyMatrixIsFine) {
  const auto symbolic = std::make_shared<const BlockSymbolic>(0, std::span<const std::array<int, 2>>{});
  ReferenceCholesky reference(symbolic);
  EXPECT_TRUE(reference.factor(BlockMatrix(symbolic)));
  VecX x;
  reference.solve(x);
}

}  // namespace glenoid::test
