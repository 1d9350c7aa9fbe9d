// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "simcore/linear/KernelTable.h"
#include "tests/simcore/linear/Problems.h"

namespace glenoid::test {

TEST(BlockMatrix, addWritesBothTrianglesOnceAndBlockReadsThem) {
  const Pattern pattern{"triangle", 3, {{0, 1}, {2, 1}}};
  BlockMatrix A(std::make_shared<const BlockSymbolic>(pattern.blocks, pattern.pairs));
  Mat3 block;
  block << 1, 2, 3, 4, 5, 6, 7, 8, 9;
  A.add(A.symbolic().entry(0, 1), block);
  A.add(A.symbolic().entry(1, 0), block);  // the mirrored position asks for the transpose
  A.add(A.symbolic().entry(2, 1), block);
  EXPECT_EQ(A.block(0, 1), block + block.transpose());
  EXPECT_EQ(A.block(1, 0), block + block.transpose());
  EXPECT_EQ(A.block(2, 1), block);
  EXPECT_EQ(A.block(1, 2), block.transpose());
  EXPECT_EQ(A.block(0, 2), Mat3::Zero());
  const MatX dense = A.toDense();
  EXPECT_EQ(dense, MatX(dense.transpose()));
  EXPECT_EQ((dense.block<3, 3>(6, 3)), block);
  A.setZero();
  EXPECT_EQ(A.toDense().norm(), 0.0);
}

TEST(BlockMatrix, slotsAreColumnsOfFourLanesOnThirtyTwoBytes) {
  const Pattern pattern = patterns()[2];
  BlockMatrix A = randomSpd(pattern, 1);
  const BlockEntry entry = A.symbolic().entry(4, 5);
  const Mat3 expected = entry.transposed ? A.block(5, 4) : A.block(4, 5);
  for (int s = 0; s < A.symbolic().slotCount(); ++s)
    EXPECT_EQ(reinterpret_cast<std::uintptr_t>(A.slot(s)) % 32, 0u);
  for (int c = 0; c < 3; ++c)
    for (int r = 0; r < 3; ++r) EXPECT_EQ(A.slot(entry.slot)[4 * c + r], expected(r, c));
}

TEST(BlockMatrix, multiplyIsThatOfTheDenseMatrix) {
  for (const Pattern& pattern : patterns()) {
    const BlockMatrix A = randomSpd(pattern, 3);
    const VecX x = Random(4).vector(3 * pattern.blocks);
    VecX y;
    A.multiply(x, y);
    const MatX dense = A.toDense();
    // Round-off of sums of at most 3 blockCount terms.
    EXPECT_LT((y - dense * x).norm(), 1e-14 * dense.norm() * x.norm()) << pattern.name;
  }
}

TEST(BlockMatrix, multiplyGivesTheSameBitsOnEveryInstructionSet) {
  const KernelTable* fast = avx2Kernels();
  if (!fast) GTEST_SKIP() << "this processor has only the portable kernels";
  for (const Pattern& pattern : patterns()) {
    const BlockMatrix A = randomSpd(pattern, 5);
    const auto stored = A.symbolic().stored();
    AlignedBuffer x(static_cast<std::size_t>(4 * pattern.blocks), 0.0), one = x, two = x;
    Random random(6);
    for (int i = 0; i < pattern.blocks; ++i)
      for (int r = 0; r < 3; ++r) x[static_cast<std::size_t>(4 * i + r)] = random.symmetric();
    const auto run = [&](const KernelTable& table, AlignedBuffer& y) {
      table.multiply(stored.data(), static_cast<int>(stored.size()), A.values().data(), x.data(), y.data());
    };
    run(*fast, one);
    run(portableKernels(), two);
    EXPECT_EQ(one, two) << pattern.name;
  }
}

}  // namespace glenoid::test
