// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "simcore/linear/BlockCholesky.h"
#include "tests/simcore/linear/Problems.h"

namespace glenoid::test {

TEST(BlockSymbolic, orderIsAPermutationAndEveryParentComesLater) {
  for (const Pattern& pattern : patterns()) {
    const BlockSymbolic symbolic(pattern.blocks, pattern.pairs);
    ASSERT_EQ(symbolic.blockCount(), pattern.blocks);
    std::set<int> seen;
    for (int i = 0; i < pattern.blocks; ++i) {
      seen.insert(symbolic.position(i));
      EXPECT_EQ(symbolic.blockAt(symbolic.position(i)), i);
    }
    EXPECT_EQ(static_cast<int>(seen.size()), pattern.blocks);
    for (int j = 0; j < pattern.blocks; ++j) {
      const int parent = symbolic.parents()[j];
      EXPECT_TRUE(parent == -1 || parent > j) << pattern.name;
      // The parent is the first row below the diagonal.
      const int below = symbolic.columnStarts()[j] + 1;
      EXPECT_EQ(parent, below < symbolic.columnStarts()[j + 1] ? symbolic.rows()[below] : -1) << pattern.name;
    }
  }
}

TEST(BlockSymbolic, entriesAreExactlyThePatternOfA) {
  for (const Pattern& pattern : patterns()) {
    const BlockSymbolic symbolic(pattern.blocks, pattern.pairs);
    std::set<std::array<int, 2>> expected;
    for (int i = 0; i < pattern.blocks; ++i) expected.insert({i, i});
    for (const auto& [row, col] : pattern.pairs) {
      expected.insert({row, col});
      expected.insert({col, row});
    }
    for (int row = 0; row < pattern.blocks; ++row) {
      for (int col = 0; col < pattern.blocks; ++col) {
        const BlockEntry entry = symbolic.entry(row, col);
        EXPECT_EQ(entry.slot >= 0, expected.contains({row, col})) << pattern.name << row << ',' << col;
        const BlockEntry mirrored = symbolic.entry(col, row);
        EXPECT_EQ(entry.slot, mirrored.slot);
        if (entry.slot >= 0 && row != col) {
          EXPECT_NE(entry.transposed, mirrored.transposed);
        }
      }
    }
    EXPECT_EQ(2 * symbolic.stored().size() - static_cast<std::size_t>(pattern.blocks), expected.size());
  }
}

TEST(BlockSymbolic, fillIsThatOfEliminationOnASet) {
  for (const Pattern& pattern : patterns()) {
    const BlockSymbolic symbolic(pattern.blocks, pattern.pairs);
    // Elimination as in the textbook: a column joins all rows below it.
    std::vector<std::set<int>> columns(static_cast<std::size_t>(pattern.blocks));
    for (const auto& [row, col] : pattern.pairs) {
      const int low = std::min(symbolic.position(row), symbolic.position(col));
      const int high = std::max(symbolic.position(row), symbolic.position(col));
      if (low != high) columns[static_cast<std::size_t>(low)].insert(high);
    }
    std::size_t slots = 0;
    for (int j = 0; j < pattern.blocks; ++j) {
      const auto& column = columns[static_cast<std::size_t>(j)];
      slots += column.size() + 1;
      for (const int a : column)
        for (const int b : column)
          if (a < b) columns[static_cast<std::size_t>(a)].insert(b);
    }
    EXPECT_EQ(static_cast<std::size_t>(symbolic.slotCount()), slots) << pattern.name;
  }
}

TEST(BlockSymbolic, orderingKeepsFillOfSparseGraphsSmall) {
  int trees = 0;
  for (const Pattern& pattern : patterns()) {
    if (pattern.name != "chain" && pattern.name != "star" && pattern.name != "islands") continue;
    const BlockSymbolic symbolic(pattern.blocks, pattern.pairs);
    // Trees have an ordering without any fill, and minimum degree finds it.
    EXPECT_EQ(static_cast<std::size_t>(symbolic.slotCount()), symbolic.stored().size()) << pattern.name;
    ++trees;
  }
  EXPECT_EQ(trees, 3);
}

/// A square sheet with diagonals, `n` blocks along each side.
Pattern sheet(int n) {
  Pattern pattern{"sheet", n * n, {}};
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j) {
      if (i + 1 < n) pattern.pairs.push_back({i * n + j, (i + 1) * n + j});
      if (j + 1 < n) pattern.pairs.push_back({i * n + j, i * n + j + 1});
      if (i + 1 < n && j + 1 < n) pattern.pairs.push_back({i * n + j, (i + 1) * n + j + 1});
    }
  return pattern;
}

TEST(BlockSymbolic, aLargeGraphIsDissectedAndASmallOneIsNot) {
  const Pattern small = sheet(50), large = sheet(70);
  ASSERT_LT(small.blocks, BlockSymbolic::kDissectFrom);
  ASSERT_GE(large.blocks, BlockSymbolic::kDissectFrom);
  EXPECT_EQ(BlockSymbolic(small.blocks, small.pairs).ordering(), BlockOrdering::MinimumDegree);

  const BlockMatrix A = randomSpd(large, 7);
  const BlockSymbolic& symbolic = A.symbolic();
  EXPECT_EQ(symbolic.ordering(), BlockOrdering::NestedDissection);
  const BlockSymbolic again(large.blocks, large.pairs);
  std::set<int> seen;
  for (int i = 0; i < large.blocks; ++i) {
    seen.insert(symbolic.position(i));
    EXPECT_EQ(again.position(i), symbolic.position(i));  // same graph, same order
  }
  EXPECT_EQ(static_cast<int>(seen.size()), large.blocks);
  // Separators of a sheet halve: n, n/2, n/2, n/4, … blocks on the way from a leaf to the root, below 4 n in all.
  EXPECT_LT(*std::max_element(symbolic.depths().begin(), symbolic.depths().end()), 4 * 70);

  BlockCholesky cholesky(A.sharedSymbolic());
  ASSERT_TRUE(cholesky.factor(A));
  const VecX x = Random(3).vector(3 * large.blocks);
  VecX y;
  A.multiply(x, y);
  cholesky.solve(y);
  // The shift of 1 keeps cond(A) below 1e3.
  EXPECT_LT((y - x).norm(), 1e-12 * x.norm());
}

TEST(BlockSymbolic, emptyMatrixIsFine) {
  const BlockSymbolic symbolic(0, {});
  EXPECT_EQ(symbolic.blockCount(), 0);
  EXPECT_EQ(symbolic.slotCount(), 0);
}

TEST(BlockSymbolic, orderOfPairsDoesNotMatter) {
  for (const Pattern& pattern : patterns()) {
    Pairs reversed(pattern.pairs.rbegin(), pattern.pairs.rend());
    for (auto& pair : reversed) std::swap(pair[0], pair[1]);
    const BlockSymbolic one(pattern.blocks, pattern.pairs);
    const BlockSymbolic two(pattern.blocks, reversed);
    for (int i = 0; i < pattern.blocks; ++i) EXPECT_EQ(one.position(i), two.position(i));
    EXPECT_EQ(one.slotCount(), two.slotCount());
  }
}

}  // namespace glenoid::test
