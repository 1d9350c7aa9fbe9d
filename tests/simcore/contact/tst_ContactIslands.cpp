// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "simcore/contact/ContactIslands.h"

namespace glenoid {
namespace {

using Sides = std::vector<std::array<int, 2>>;

TEST(ContactIslands, toolsAndTissueMeetInOne) {
  ContactIslandBuilder builder(4);  // 0: tissue, 1 and 2: tools, 3: apart
  const auto islands = builder.build(Sides{{0, 1}, {0, 2}});
  ASSERT_EQ(islands.size(), 1u);
  EXPECT_EQ(islands[0].couplingIslands, (std::vector<int>{0, 1, 2}));
  EXPECT_EQ(islands[0].contacts, (std::vector<int>{0, 1}));
}

TEST(ContactIslands, aFixedSideJoinsNothing) {
  ContactIslandBuilder builder(2);
  const auto islands = builder.build(Sides{{0, -1}, {-1, 1}, {-1, -1}});
  ASSERT_EQ(islands.size(), 2u);
  EXPECT_EQ(islands[0].contacts, std::vector<int>{0});
  EXPECT_EQ(islands[1].contacts, std::vector<int>{1});
}

TEST(ContactIslands, orderOfContactsDoesNotMatterForTheGroups) {
  ContactIslandBuilder builder(6);
  const Sides forward{{0, 3}, {1, 4}, {3, 5}}, backward{{5, 3}, {4, 1}, {3, 0}};
  std::vector<std::vector<int>> first, second;
  for (const ContactIsland& island : builder.build(forward)) first.push_back(island.couplingIslands);
  for (const ContactIsland& island : builder.build(backward)) second.push_back(island.couplingIslands);
  EXPECT_EQ(first, second);
  EXPECT_EQ(first, (std::vector<std::vector<int>>{{0, 3, 5}, {1, 4}}));
}

TEST(ContactIslands, aLaterStepForgetsTheEarlier) {
  ContactIslandBuilder builder(3);
  builder.build(Sides{{0, 1}, {1, 2}});
  const auto islands = builder.build(Sides{{2, 2}});
  ASSERT_EQ(islands.size(), 1u);
  EXPECT_EQ(islands[0].couplingIslands, std::vector<int>{2});
  EXPECT_EQ(islands[0].contacts, std::vector<int>{0});
}

}  // namespace
}  // namespace glenoid
