// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <span>
#include <utility>
#include <vector>

#ifdef __SSE2__
#include <emmintrin.h>
#endif

#include "simcore/base/Math.h"

namespace glenoid {

/// Binary tree of axis-aligned boxes in single precision, rounded outwards: right for throwing away what is
/// far, never for deciding what is near. Bullet's btDbvt decides the shape of the tree once; after that boxes
/// are refitted bottom-up while the shape stays, so a query visits nodes in the same order on every run. Any
/// frame and unit. Building allocates; refitting and walking do not.
class BoxTree {
 public:
  struct alignas(32) Node {
    std::array<float, 3> low;
    std::int32_t first;  ///< inner: left child (right child is `second`); leaf: −1
    std::array<float, 3> high;
    std::int32_t second;  ///< inner: right child; leaf: the item
    bool leaf() const { return first < 0; }
    int item() const { return second; }
  };
  static constexpr int kMaxDepth = 64;  ///< a build that would go deeper is split evenly instead

  BoxTree() = default;
  /// One leaf for each box, item i for boxes[i]. Empty boxes are not allowed.
  explicit BoxTree(std::span<const Box3> boxes);

  bool empty() const { return m_nodes.empty(); }
  /// Root is node 0; children come after their parent.
  std::span<const Node> nodes() const { return m_nodes; }
  /// Node index of an item's leaf.
  int leafOf(int item) const { return m_leafOfItem[item]; }
  int itemCount() const { return static_cast<int>(m_leafOfItem.size()); }

  /// Replaces an item's box; call refit() after the last one. `low` and `high` are widened to floats.
  void setBox(int item, const Vec3& low, const Vec3& high) {
    Node& node = m_nodes[m_leafOfItem[item]];
    for (int k = 0; k < 3; ++k) {
      node.low[k] = roundDown(low[k]);
      node.high[k] = roundUp(high[k]);
    }
  }
  void refit();

  /// To single precision, never to the wrong side: one unit in the last place covers the conversion's half.
  static float roundDown(double x) { return static_cast<float>(x - std::abs(x) * kUlp - kTiny); }
  static float roundUp(double x) { return static_cast<float>(x + std::abs(x) * kUlp + kTiny); }

  static bool overlap(const Node& a, const Node& b) {
#ifdef __SSE2__
    // The fourth lane holds child numbers and is not looked at.
    const __m128 lowA = _mm_load_ps(a.low.data()), highA = _mm_load_ps(a.high.data());
    const __m128 lowB = _mm_load_ps(b.low.data()), highB = _mm_load_ps(b.high.data());
    return (_mm_movemask_ps(_mm_and_ps(_mm_cmple_ps(lowA, highB), _mm_cmple_ps(lowB, highA))) & 7) == 7;
#else
    return (a.low[0] <= b.high[0]) & (b.low[0] <= a.high[0]) & (a.low[1] <= b.high[1]) &
           (b.low[1] <= a.high[1]) & (a.low[2] <= b.high[2]) & (b.low[2] <= a.high[2]);
#endif
  }

  /// Squared distance from a point to a node's box; a lower bound for everything inside.
  static double squaredDistance(const Node& node, const Vec3& p) {
    double sum = 0;
    for (int k = 0; k < 3; ++k) {
      const double below = node.low[k] - p[k], above = p[k] - node.high[k];
      const double d = below > above ? below : above;
      if (d > 0) sum += d * d;
    }
    return sum;
  }

  /// Calls visit(item) for every leaf whose chain of boxes satisfies meets(node).
  template <class Meets, class Visit>
  void walk(Meets&& meets, Visit&& visit) const {
    if (m_nodes.empty()) return;
    std::array<std::int32_t, kMaxDepth + 2> stack;
    int top = 0;
    stack[top++] = 0;
    while (top > 0) {
      const Node& node = m_nodes[stack[--top]];
      if (!meets(node)) continue;
      if (node.leaf()) {
        visit(node.item());
      } else {
        stack[top++] = node.second;
        stack[top++] = node.first;
      }
    }
  }

  /// How far one tree's boxes may be carried against another's, per axis: from `low` ≤ 0 to `high` ≥ 0.
  struct alignas(16) Sweep {
    std::array<float, 4> low{}, high{};
    bool none() const { return low == std::array<float, 4>{} && high == std::array<float, 4>{}; }
  };
  static bool overlap(const Node& a, const Sweep& sweep, const Node& b) {
#ifdef __SSE2__
    const __m128 lowA = _mm_add_ps(_mm_load_ps(a.low.data()), _mm_load_ps(sweep.low.data()));
    const __m128 highA = _mm_add_ps(_mm_load_ps(a.high.data()), _mm_load_ps(sweep.high.data()));
    const __m128 lowB = _mm_load_ps(b.low.data()), highB = _mm_load_ps(b.high.data());
    return (_mm_movemask_ps(_mm_and_ps(_mm_cmple_ps(lowA, highB), _mm_cmple_ps(lowB, highA))) & 7) == 7;
#else
    bool yes = true;
    for (int k = 0; k < 3; ++k)
      yes &= (a.low[k] + sweep.low[k] <= b.high[k]) & (b.low[k] <= a.high[k] + sweep.high[k]);
    return yes;
#endif
  }

  /// Calls visit(itemA, itemB) for every two leaves whose boxes overlap, those of `a` carried as far as `sweep` says.
  template <class Visit>
  static void walkPairs(const BoxTree& a, const BoxTree& b, const Sweep& sweep, Visit&& visit) {
    if (sweep.none()) return walkPairs(a, b, visit);
    walkPairsWhere(a, b, visit, [&sweep](const Node& i, const Node& j) { return overlap(i, sweep, j); });
  }
  template <class Visit>
  static void walkPairs(const BoxTree& a, const BoxTree& b, Visit&& visit) {
    walkPairsWhere(a, b, visit, [](const Node& i, const Node& j) { return overlap(i, j); });
  }

  /// Calls visit(i, j) once for every two different leaves of this tree whose boxes overlap, in the same order on every run.
  /// What may(nodeIndex, nodeIndex) refuses is left out with all that is under it; both indices may be the same.
  template <class Visit, class May>
  void walkSelf(Visit&& visit, May&& may) const {
    if (m_nodes.empty()) return;
    std::array<std::array<std::int32_t, 2>, 3 * kMaxDepth + 4> stack;
    int top = 0;
    const auto push = [&](std::int32_t i, std::int32_t j) {
      stack[top] = {i, j};
      top += (i == j || overlap(m_nodes[i], m_nodes[j])) && may(i, j);
    };
    push(0, 0);
    while (top > 0) {
      const auto [i, j] = stack[--top];
      const Node& a = m_nodes[i];
      const Node& b = m_nodes[j];
      if (i == j) {
        if (a.leaf()) continue;
        push(a.second, a.second);
        push(a.first, a.first);
        push(a.first, a.second);
      } else if (!a.leaf() && !b.leaf()) {
        push(a.second, b.second);
        push(a.second, b.first);
        push(a.first, b.second);
        push(a.first, b.first);
      } else if (!a.leaf()) {
        push(a.second, j);
        push(a.first, j);
      } else if (!b.leaf()) {
        push(i, b.second);
        push(i, b.first);
      } else {
        visit(a.item(), b.item());
      }
    }
  }

  /// Nearest item: evaluate(item, best) returns the squared distance of an item, or anything ≥ best if it is
  /// not nearer. Starts from `best` (squared) and returns the least found. Nearer child first. Stops looking
  /// as soon as the best is not above `enough`.
  template <class Evaluate>
  double nearest(const Vec3& p, double best, Evaluate&& evaluate, double enough = -1) const {
    if (m_nodes.empty()) return best;
    struct Entry {
      double bound;
      std::int32_t node;
    };
    std::array<Entry, kMaxDepth + 2> stack;
    int top = 0;
    stack[top++] = {squaredDistance(m_nodes[0], p), 0};
    while (top > 0) {
      const Entry entry = stack[--top];
      if (entry.bound > best) continue;
      const Node& node = m_nodes[entry.node];
      if (node.leaf()) {
        const double d = evaluate(node.item(), best);
        if (d < best) best = d;
        if (best <= enough) return best;
        continue;
      }
      Entry left{squaredDistance(m_nodes[node.first], p), node.first};
      Entry right{squaredDistance(m_nodes[node.second], p), node.second};
      if (right.bound < left.bound) std::swap(left, right);
      stack[top++] = right;
      stack[top++] = left;
    }
    return best;
  }

 private:
  /// Pairs of children are always written to the stack and kept by moving its top: whether they overlap is too
  /// irregular for the branch predictor.
  template <class Visit, class Meets>
  static void walkPairsWhere(const BoxTree& a, const BoxTree& b, Visit&& visit, Meets&& meets) {
    if (a.empty() || b.empty() || !meets(a.m_nodes[0], b.m_nodes[0])) return;
    std::array<std::array<std::int32_t, 2>, 3 * kMaxDepth + 4> stack;
    int top = 0;
    const auto push = [&](std::int32_t i, std::int32_t j) {
      stack[top] = {i, j};
      top += meets(a.m_nodes[i], b.m_nodes[j]);
    };
    push(0, 0);
    while (top > 0) {
      const auto [i, j] = stack[--top];
      const Node& na = a.m_nodes[i];
      const Node& nb = b.m_nodes[j];
      if (!na.leaf() && !nb.leaf()) {
        push(na.second, nb.second);
        push(na.second, nb.first);
        push(na.first, nb.second);
        push(na.first, nb.first);
      } else if (!na.leaf()) {
        push(na.second, j);
        push(na.first, j);
      } else if (!nb.leaf()) {
        push(i, nb.second);
        push(i, nb.first);
      } else {
        visit(na.item(), nb.item());
      }
    }
  }

  static constexpr double kUlp = std::numeric_limits<float>::epsilon();
  static constexpr double kTiny = std::numeric_limits<float>::min();

  std::vector<Node> m_nodes;
  std::vector<std::int32_t> m_leafOfItem;
};

}  // namespace glenoid
