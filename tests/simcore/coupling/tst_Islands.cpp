// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "simcore/coupling/Islands.h"

namespace glenoid {
namespace {

using Pairs = std::vector<std::array<int, 2>>;

TEST(CouplingIslands, growAlongCouplingsAndStopAtFixedObjects) {
  // 0 fixed; 1–2 and 3 hang on it; 4 alone.
  const CouplingIslands islands = findCouplingIslands({false, true, true, true, true}, Pairs{{1, 0}, {1, 2}, {3, 0}});
  EXPECT_EQ(islands.islandOfObject, (std::vector<int>{-1, 0, 0, 1, 2}));
  EXPECT_EQ(islands.objects, (std::vector<std::vector<int>>{{1, 2}, {3}, {4}}));
}

TEST(CouplingIslands, theShouldersCouplingsGiveOneLargeIsland) {
  // Parts 1…11 as 0…10; scapula fixed. 6 hangs on the scapula alone.
  const Pairs couplings{{2, 0}, {3, 0}, {4, 0}, {5, 0}, {5, 0}, {6, 0}, {8, 0}, {2, 1}, {3, 1}, {4, 1}, {6, 1}, {7, 1}, {7, 1}, {10, 1}, {9, 8}, {9, 10}};
  std::vector<bool> isFree(11, true);
  isFree[0] = false;
  const CouplingIslands islands = findCouplingIslands(isFree, couplings);
  ASSERT_EQ(islands.objects.size(), 2u);
  EXPECT_EQ(islands.objects[0], (std::vector<int>{1, 2, 3, 4, 6, 7, 8, 9, 10}));
  EXPECT_EQ(islands.objects[1], std::vector<int>{5});
}

TEST(CouplingIslands, orderOfCouplingsDoesNotMatter) {
  const std::vector<bool> isFree(6, true);
  const CouplingIslands a = findCouplingIslands(isFree, Pairs{{0, 5}, {5, 2}, {3, 4}});
  const CouplingIslands b = findCouplingIslands(isFree, Pairs{{4, 3}, {2, 5}, {5, 0}});
  EXPECT_EQ(a.objects, b.objects);
}

}  // namespace
}  // namespace glenoid
