// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/linear/BlockSymbolic.h"

#include <amd.h>
#include <cholmod.h>

#include <algorithm>
#include <cassert>

#include "simcore/linear/ExpectedFill.h"

namespace glenoid {
namespace {

/// Neighbours of each block in both directions, sorted, without the diagonal.
struct Graph {
  std::vector<int> start, neighbours;
  std::span<const int> of(int block) const {
    return {neighbours.data() + start[block], static_cast<std::size_t>(start[block + 1] - start[block])};
  }
};

Graph makeGraph(int blockCount, std::span<const std::array<int, 2>> pairs) {
  std::vector<std::array<int, 2>> edges;
  edges.reserve(2 * pairs.size());
  for (const auto& [row, col] : pairs) {
    assert(row >= 0 && row < blockCount && col >= 0 && col < blockCount);
    if (row == col) continue;
    edges.push_back({row, col});
    edges.push_back({col, row});
  }
  std::sort(edges.begin(), edges.end());
  edges.erase(std::unique(edges.begin(), edges.end()), edges.end());
  Graph graph;
  graph.start.assign(blockCount + 1, 0);
  for (const auto& edge : edges) ++graph.start[edge[0] + 1];
  for (int i = 0; i < blockCount; ++i) graph.start[i + 1] += graph.start[i];
  graph.neighbours.reserve(edges.size());
  for (const auto& edge : edges) graph.neighbours.push_back(edge[1]);
  return graph;
}

/// Approximate minimum degree; the order as given when AMD runs out of memory. `info`: AMD_INFO numbers of AMD's, or null.
std::vector<int> amdOrder(const Graph& graph, int blockCount, double* info = nullptr) {
  std::vector<int> order(blockCount);
  const int none = 0;  // AMD wants a pointer even for no entries
  const int status =
      amd_order(blockCount, graph.start.data(), graph.neighbours.empty() ? &none : graph.neighbours.data(),
                order.data(), nullptr, info);
  if (status != AMD_OK)
    for (int i = 0; i < blockCount; ++i) order[i] = i;
  return order;
}

/// Nested dissection by METIS, through CHOLMOD; empty where it is not built in or runs out of memory.
std::vector<int> dissectionOrder(const Graph& graph, int blockCount) {
  cholmod_common common;
  cholmod_start(&common);
  common.print = 0;
  const auto n = static_cast<std::size_t>(blockCount);
  std::vector<int> order(n);
  bool good = false;
  if (cholmod_sparse* pattern = cholmod_allocate_sparse(n, n, graph.neighbours.size(), 1, 1, 1, CHOLMOD_PATTERN, &common)) {
    // Symmetric with the upper triangle stored: the lower one is ignored.
    std::copy(graph.start.begin(), graph.start.end(), static_cast<int*>(pattern->p));
    std::copy(graph.neighbours.begin(), graph.neighbours.end(), static_cast<int*>(pattern->i));
    good = cholmod_metis(pattern, nullptr, 0, 0, order.data(), &common) != 0;
    cholmod_free_sparse(&pattern, &common);
  }
  cholmod_finish(&common);
  return good ? order : std::vector<int>();
}

std::vector<int> inverse(const std::vector<int>& order) {
  std::vector<int> result(order.size());
  for (std::size_t i = 0; i < order.size(); ++i) result[order[i]] = static_cast<int>(i);
  return result;
}

/// Liu's algorithm with path compression: the parent of j is the first row below j in column j of L.
std::vector<int> eliminationTree(const Graph& graph, const std::vector<int>& blockAt,
                                 const std::vector<int>& position) {
  const int n = static_cast<int>(blockAt.size());
  std::vector<int> parent(n, -1), ancestor(n, -1);
  for (int j = 0; j < n; ++j) {
    for (const int neighbour : graph.of(blockAt[j])) {
      int i = position[neighbour];
      while (i >= 0 && i < j) {
        const int next = ancestor[i];
        ancestor[i] = j;
        if (next < 0) parent[i] = j;
        i = next;
      }
    }
  }
  return parent;
}

/// Order of the tree's nodes with every subtree contiguous, children ascending.
std::vector<int> postorder(const std::vector<int>& parent) {
  const int n = static_cast<int>(parent.size());
  std::vector<int> firstChild(n, -1), nextSibling(n, -1), order, stack;
  order.reserve(n);
  for (int j = n - 1; j >= 0; --j) {
    if (parent[j] < 0) continue;
    nextSibling[j] = firstChild[parent[j]];
    firstChild[parent[j]] = j;
  }
  for (int root = 0; root < n; ++root) {
    if (parent[root] >= 0) continue;
    stack.push_back(root);
    while (!stack.empty()) {
      const int j = stack.back();
      if (firstChild[j] >= 0) {
        stack.push_back(firstChild[j]);
        firstChild[j] = nextSibling[firstChild[j]];  // each child is entered once
      } else {
        order.push_back(j);
        stack.pop_back();
      }
    }
  }
  return order;
}

}  // namespace

BlockSymbolic::BlockSymbolic(int blockCount, std::span<const std::array<int, 2>> pairs) {
  assert(blockCount >= 0);
  const int n = blockCount;
  const Graph graph = makeGraph(n, pairs);
  if (n >= kDissectFrom) m_blockAt = dissectionOrder(graph, n);
  m_ordering = m_blockAt.empty() ? BlockOrdering::MinimumDegree : BlockOrdering::NestedDissection;
  if (m_blockAt.empty()) m_blockAt = amdOrder(graph, n);
  m_position = inverse(m_blockAt);

  // Postorder changes no fill and puts related columns side by side in memory.
  const std::vector<int> post = postorder(eliminationTree(graph, m_blockAt, m_position));
  std::vector<int> blockAt(n);
  for (int j = 0; j < n; ++j) blockAt[j] = m_blockAt[post[j]];
  m_blockAt = std::move(blockAt);
  m_position = inverse(m_blockAt);
  m_parent = eliminationTree(graph, m_blockAt, m_position);
  m_depth.assign(n, 0);
  for (int j = n - 1; j >= 0; --j) m_depth[j] = m_parent[j] < 0 ? 0 : m_depth[m_parent[j]] + 1;

  // Column j of L: the rows of A below j and everything its children pass on.
  std::vector<int> mark(n, -1), firstChild(n, -1), nextSibling(n, -1);
  for (int j = n - 1; j >= 0; --j) {
    if (m_parent[j] < 0) continue;
    nextSibling[j] = firstChild[m_parent[j]];
    firstChild[m_parent[j]] = j;
  }
  m_columnStart.assign(n + 1, 0);
  for (int j = 0; j < n; ++j) {
    const std::size_t start = m_rows.size();
    const auto put = [&](int row) {
      if (row < j || mark[row] == j) return;
      mark[row] = j;
      m_rows.push_back(row);
    };
    put(j);
    for (const int neighbour : graph.of(m_blockAt[j])) put(m_position[neighbour]);
    for (int child = firstChild[j]; child >= 0; child = nextSibling[child])
      for (int s = m_columnStart[child] + 1; s < m_columnStart[child + 1]; ++s) put(m_rows[s]);
    std::sort(m_rows.begin() + static_cast<std::ptrdiff_t>(start), m_rows.end());
    m_columnStart[j + 1] = static_cast<int>(m_rows.size());
  }

  m_inA.assign(m_rows.size(), 0);
  for (int j = 0; j < n; ++j) {
    const auto neighbours = graph.of(m_blockAt[j]);
    for (const int neighbour : neighbours) mark[m_position[neighbour]] = n + j;
    for (int s = m_columnStart[j]; s < m_columnStart[j + 1]; ++s) {
      if (m_rows[s] != j && mark[m_rows[s]] != n + j) continue;
      m_inA[s] = 1;
      m_stored.push_back({s, m_blockAt[m_rows[s]], m_blockAt[j]});
    }
  }

  // Updates of column j: one for each earlier column with a block in row j, in ascending order.
  m_updateStart.assign(n + 1, 0);
  for (int k = 0; k < n; ++k)
    for (int s = m_columnStart[k] + 1; s < m_columnStart[k + 1]; ++s) ++m_updateStart[m_rows[s] + 1];
  for (int j = 0; j < n; ++j) m_updateStart[j + 1] += m_updateStart[j];
  m_updates.resize(m_updateStart[n]);
  std::vector<int> next(m_updateStart.begin(), m_updateStart.end() - 1);
  for (int k = 0; k < n; ++k)
    for (int s = m_columnStart[k] + 1; s < m_columnStart[k + 1]; ++s)
      m_updates[next[m_rows[s]]++] = {s, m_columnStart[k + 1] - s, 0};
  std::vector<int> place(n, -1);
  for (int j = 0; j < n; ++j) {
    for (int s = m_columnStart[j]; s < m_columnStart[j + 1]; ++s) place[m_rows[s]] = s - m_columnStart[j];
    for (int u = m_updateStart[j]; u < m_updateStart[j + 1]; ++u) {
      Update& update = m_updates[u];
      update.firstTarget = static_cast<int>(m_targets.size());
      for (int t = 0; t < update.count; ++t) m_targets.push_back(place[m_rows[update.source + t]]);
    }
  }
}

BlockEntry BlockSymbolic::entry(int row, int col) const {
  assert(row >= 0 && row < blockCount() && col >= 0 && col < blockCount());
  const bool transposed = m_position[row] < m_position[col];
  const int low = transposed ? m_position[col] : m_position[row];
  const int column = transposed ? m_position[row] : m_position[col];
  const auto first = m_rows.begin() + m_columnStart[column];
  const auto last = m_rows.begin() + m_columnStart[column + 1];
  const auto found = std::lower_bound(first, last, low);
  if (found == last || *found != low) return {};
  const int slot = static_cast<int>(found - m_rows.begin());
  if (!m_inA[slot]) return {};
  return {slot, transposed};
}

double expectedUpdates(int blockCount, std::span<const std::array<int, 2>> pairs) {
  std::array<double, AMD_INFO> info{};
  amdOrder(makeGraph(blockCount, pairs), blockCount, info.data());
  return info[AMD_NMULTSUBS_LDL];
}

}  // namespace glenoid
