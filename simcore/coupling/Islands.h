// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <span>
#include <vector>

namespace glenoid {

/// Disjoint sets of 0…count−1 with the smallest member as name: the same answer whatever the order of unions.
class DisjointSets {
 public:
  explicit DisjointSets(int count) { reset(count); }
  void reset(int count);
  int find(int item);
  void unite(int a, int b);

 private:
  std::vector<int> m_parent;
};

/// Coupling islands: objects joined by couplings, fixed objects joining none (paper §5.2; found once, since
/// couplings are neither made nor dropped at run time).
struct CouplingIslands {
  std::vector<int> islandOfObject;            ///< −1: fixed
  std::vector<std::vector<int>> objects;      ///< of each island, ascending; islands by their first object
};

CouplingIslands findCouplingIslands(const std::vector<bool>& isFree, std::span<const std::array<int, 2>> couplings);

}  // namespace glenoid
