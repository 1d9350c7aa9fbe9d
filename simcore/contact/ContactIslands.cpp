// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/contact/ContactIslands.h"

#include <algorithm>

namespace glenoid {

ContactIslandBuilder::ContactIslandBuilder(int couplingIslandCount)
    : m_count(couplingIslandCount), m_sets(couplingIslandCount), m_islandOfRoot(couplingIslandCount) {}

std::span<const ContactIsland> ContactIslandBuilder::build(std::span<const std::array<int, 2>> sides) {
  m_sets.reset(m_count);
  std::fill(m_islandOfRoot.begin(), m_islandOfRoot.end(), -2);  // −2: touched by no contact
  for (const auto& [a, b] : sides)
    if (a >= 0 && b >= 0) m_sets.unite(a, b);
  for (const auto& [a, b] : sides)
    if (a >= 0 || b >= 0) m_islandOfRoot[m_sets.find(a >= 0 ? a : b)] = -1;
  std::size_t count = 0;
  for (int island = 0; island < m_count; ++island) {
    const int root = m_sets.find(island);
    if (m_islandOfRoot[root] == -2) continue;
    if (m_islandOfRoot[root] == -1) {
      m_islandOfRoot[root] = static_cast<int>(count);
      if (m_islands.size() == count) m_islands.emplace_back();
      m_islands[count].couplingIslands.clear();
      m_islands[count].contacts.clear();
      ++count;
    }
    m_islands[m_islandOfRoot[root]].couplingIslands.push_back(island);
  }
  for (std::size_t contact = 0; contact < sides.size(); ++contact) {
    const auto& [a, b] = sides[contact];
    if (a < 0 && b < 0) continue;
    m_islands[m_islandOfRoot[m_sets.find(a >= 0 ? a : b)]].contacts.push_back(static_cast<int>(contact));
  }
  return {m_islands.data(), count};
}

}  // namespace glenoid
