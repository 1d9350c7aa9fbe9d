// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>

#include "tests/scenes/BlockScenes.h"

/// Joints whose parts are held at picked nodes.
namespace glenoid::scenes {

/// Nodes of a part's cells for which this holds, ascending.
inline std::vector<int> nodesWhere(const Part& part, const std::function<bool(const Vec3&)>& holds) {
  std::vector<int> nodes;
  for (std::size_t i = 0; i < part.volume->nodes.size(); ++i)
    if (holds(part.volume->nodes[i])) nodes.push_back(static_cast<int>(i));
  return nodes;
}

/// A coupling at nodes.
inline Coupling atNodes(const std::string& id, const std::string& a, const std::string& b, std::vector<int> nodes, double stiffness, double damping = 1e-3) {
  Coupling coupling;
  coupling.id = id;
  coupling.partA = a;
  coupling.partB = b;
  coupling.nodesA = std::move(nodes);
  coupling.stiffnessPerNode = stiffness;
  coupling.damping = damping;
  return coupling;
}

/// Figure 4 with both ends of the soft part held at the nine nodes of each face, with the same stiffness in all as the regions had (40 kN/m).
inline Joint figure4AtNodes() {
  Joint joint = figure4Joint();
  const Part& middle = joint.parts[1];
  for (const double x : {-0.02, 0.02}) {
    const auto nodes = nodesWhere(middle, [x](const Vec3& p) { return std::abs(p.x() - x) < 1e-9; });
    joint.couplings[x < 0 ? 0 : 1] = atNodes(x < 0 ? "c12" : "c23", "middle", x < 0 ? "left" : "right", nodes, 4e4 / static_cast<double>(nodes.size()));
  }
  return joint;
}

}  // namespace glenoid::scenes
