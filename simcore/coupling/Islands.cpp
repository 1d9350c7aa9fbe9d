// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/coupling/Islands.h"

#include <numeric>

namespace glenoid {

void DisjointSets::reset(int count) {
  m_parent.resize(count);
  std::iota(m_parent.begin(), m_parent.end(), 0);
}

int DisjointSets::find(int item) {
  while (m_parent[item] != item) item = m_parent[item] = m_parent[m_parent[item]];
  return item;
}

void DisjointSets::unite(int a, int b) {
  a = find(a);
  b = find(b);
  if (a < b) m_parent[b] = a;
  if (b < a) m_parent[a] = b;
}

CouplingIslands findCouplingIslands(const std::vector<bool>& isFree, std::span<const std::array<int, 2>> couplings) {
  const int count = static_cast<int>(isFree.size());
  DisjointSets sets(count);
  for (const auto& [a, b] : couplings)
    if (isFree[a] && isFree[b]) sets.unite(a, b);
  CouplingIslands islands;
  islands.islandOfObject.assign(count, -1);
  for (int object = 0; object < count; ++object) {
    if (!isFree[object]) continue;
    const int root = sets.find(object);
    if (root == object) {
      islands.islandOfObject[object] = static_cast<int>(islands.objects.size());
      islands.objects.push_back({});
    }
    islands.islandOfObject[object] = islands.islandOfObject[root];
    islands.objects[islands.islandOfObject[object]].push_back(object);
  }
  return islands;
}

}  // namespace glenoid
