// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/base/Math.h"
#include "simcore/spatial/BoxTree.h"

namespace glenoid {

/// A ray along a coordinate axis, for deciding what is inside a closed surface by counting crossings. The two
/// coordinates across the ray are thought to be shifted by (ε, ε²), so that the ray meets no edge and no
/// vertex and every crossing is counted once; the decisions are exact signs. Source: Edelsbrunner and Mücke,
/// "Simulation of Simplicity", 1990.
struct AxisRay {
  Vec3 origin = Vec3::Zero();
  int axis = 0;         ///< 0, 1, 2
  bool forward = true;  ///< towards larger coordinates

  /// Whether the ray passes through the triangle. A triangle parallel to the ray is never crossed.
  bool crosses(const Vec3& a, const Vec3& b, const Vec3& c) const;

  /// Whether anything in this box can be crossed.
  bool reaches(const BoxTree::Node& node) const {
    const int u = (axis + 1) % 3, v = (axis + 2) % 3;
    return (node.low[u] <= origin[u]) & (origin[u] <= node.high[u]) & (node.low[v] <= origin[v]) &
           (origin[v] <= node.high[v]) &
           (forward ? node.high[axis] >= origin[axis] : node.low[axis] <= origin[axis]);
  }
};

/// Ray that leaves the box of `root` soonest.
AxisRay shortestRay(const Vec3& origin, const BoxTree::Node& root);

/// Whether a point is enclosed: `corners(item)` gives the three corners of a triangle as an indexable triple.
/// A surface that is not closed gives an answer without meaning. On the surface: either answer.
template <class Corners>
bool enclosedBy(const BoxTree& tree, const Vec3& point, Corners&& corners) {
  if (tree.empty()) return false;
  const AxisRay ray = shortestRay(point, tree.nodes()[0]);
  bool odd = false;
  tree.walk([&](const BoxTree::Node& node) { return ray.reaches(node); },
            [&](int item) {
              const auto& t = corners(item);
              if (ray.crosses(t[0], t[1], t[2])) odd = !odd;
            });
  return odd;
}

}  // namespace glenoid
