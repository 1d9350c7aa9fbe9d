// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/spatial/BoxTree.h"

#include <BulletCollision/BroadphaseCollision/btDbvt.h>

#include <algorithm>

namespace glenoid {
namespace {

using Node = BoxTree::Node;

int depthOf(const btDbvtNode* root) {
  int deepest = 0;
  std::vector<std::pair<const btDbvtNode*, int>> open{{root, 1}};
  while (!open.empty()) {
    const auto [node, depth] = open.back();
    open.pop_back();
    deepest = std::max(deepest, depth);
    if (node->isinternal()) {
      open.push_back({node->childs[0], depth + 1});
      open.push_back({node->childs[1], depth + 1});
    }
  }
  return deepest;
}

/// Bullet's tree in preorder; leaves get their boxes afterwards.
void flatten(const btDbvtNode* root, std::vector<Node>& nodes) {
  struct Open {
    const btDbvtNode* node;
    int parent;  ///< whose `second` this will be, −1: none
  };
  std::vector<Open> open{{root, -1}};
  while (!open.empty()) {
    const Open top = open.back();
    open.pop_back();
    const int index = static_cast<int>(nodes.size());
    if (top.parent >= 0) nodes[top.parent].second = index;
    nodes.push_back({{}, -1, {}, 0});
    if (top.node->isinternal()) {
      nodes[index].first = index + 1;
      open.push_back({top.node->childs[1], index});
      open.push_back({top.node->childs[0], -1});
    } else {
      nodes[index].second = top.node->dataAsInt;
    }
  }
}

/// Bullet's tree is the better one, but takes seconds for half a million items.
constexpr int kMostForBullet = 20000;

/// Plain halving in the order of the items along the longest side: never deeper than log2 of the count.
void halve(std::span<const Box3> boxes, std::span<int> items, std::vector<Node>& nodes) {
  const int index = static_cast<int>(nodes.size());
  nodes.push_back({{}, -1, {}, items[0]});
  if (items.size() == 1) return;
  Box3 centres;
  for (const int i : items) centres.extend(boxes[i].center());
  Eigen::Index axis = 0;
  centres.sizes().maxCoeff(&axis);
  const std::size_t half = items.size() / 2;
  std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(), [&](int i, int j) {
    const double a = boxes[i].center()[axis], b = boxes[j].center()[axis];
    return a != b ? a < b : i < j;
  });
  nodes[index].first = index + 1;
  halve(boxes, items.subspan(0, half), nodes);
  nodes[index].second = static_cast<int>(nodes.size());
  halve(boxes, items.subspan(half), nodes);
}

}  // namespace

BoxTree::BoxTree(std::span<const Box3> boxes) {
  if (boxes.empty()) return;
  const int count = static_cast<int>(boxes.size());
  m_nodes.reserve(2 * boxes.size());
  if (count <= kMostForBullet) {
    btDbvt tree;
    for (int i = 0; i < count; ++i) {
      const Vec3 low = boxes[i].min(), high = boxes[i].max();
      const btVector3 mi(btScalar(low.x()), btScalar(low.y()), btScalar(low.z()));
      const btVector3 mx(btScalar(high.x()), btScalar(high.y()), btScalar(high.z()));
      tree.insert(btDbvtVolume::FromMM(mi, mx), nullptr)->dataAsInt = i;
    }
    tree.optimizeTopDown(32);  // bottom-up merging, cubic in cost, only within groups of 32
    if (depthOf(tree.m_root) <= kMaxDepth) flatten(tree.m_root, m_nodes);
  }
  if (m_nodes.empty()) {
    std::vector<int> items(boxes.size());
    for (int i = 0; i < count; ++i) items[i] = i;
    halve(boxes, items, m_nodes);
  }
  m_leafOfItem.assign(boxes.size(), -1);
  for (int n = 0; n < static_cast<int>(m_nodes.size()); ++n) {
    if (m_nodes[n].leaf()) m_leafOfItem[m_nodes[n].item()] = n;
  }
  for (int i = 0; i < count; ++i) setBox(i, boxes[i].min(), boxes[i].max());
  refit();
}

void BoxTree::refit() {
  for (int n = static_cast<int>(m_nodes.size()) - 1; n >= 0; --n) {
    Node& node = m_nodes[n];
    if (node.leaf()) continue;
    const Node& left = m_nodes[node.first];
    const Node& right = m_nodes[node.second];
    for (int k = 0; k < 3; ++k) {
      node.low[k] = std::min(left.low[k], right.low[k]);
      node.high[k] = std::max(left.high[k], right.high[k]);
    }
  }
}

}  // namespace glenoid
