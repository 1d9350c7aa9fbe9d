// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <span>
#include <vector>

#include "simcore/coupling/Islands.h"

namespace glenoid {

/// Coupling islands that share at least one contact this step (paper §5.3): one complementarity problem each.
struct ContactIsland {
  std::vector<int> couplingIslands;  ///< ascending
  std::vector<int> contacts;         ///< ascending
};

/// Groups contacts by the coupling islands they join; −1 stands for a fixed side. Islands come in the order of
/// their first coupling island, so the answer does not depend on anything else. Scratch is kept in the object.
class ContactIslandBuilder {
 public:
  explicit ContactIslandBuilder(int couplingIslandCount);
  /// sides[c]: the coupling islands of contact c; a contact with −1 on both sides is left out.
  std::span<const ContactIsland> build(std::span<const std::array<int, 2>> sides);

 private:
  int m_count;
  DisjointSets m_sets;
  std::vector<int> m_islandOfRoot;
  std::vector<ContactIsland> m_islands;  ///< more than are in use stay, for their memory
};

}  // namespace glenoid
