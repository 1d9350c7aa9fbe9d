// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/mesh/NodePatch.h"

#include <algorithm>
#include <cmath>

#include "simcore/base/PlainMath.h"
#include "simcore/mesh/TrianglePatch.h"

namespace glenoid {
namespace {

std::vector<char> flagsOf(const TetMesh& mesh, const std::vector<int>& set) {
  std::vector<char> flags(mesh.nodes.size(), 0);
  for (const int node : set) flags[static_cast<std::size_t>(node)] = 1;
  return flags;
}

std::vector<int> nodesOf(const std::vector<char>& flags) {
  std::vector<int> set;
  for (std::size_t node = 0; node < flags.size(); ++node)
    if (flags[node]) set.push_back(static_cast<int>(node));
  return set;
}

}  // namespace

std::vector<int> usedNodes(const TetMesh& mesh) {
  std::vector<char> used(mesh.nodes.size(), 0);
  for (const auto& tet : mesh.tets)
    for (const int node : tet) used[static_cast<std::size_t>(node)] = 1;
  return nodesOf(used);
}

std::vector<int> grownNodes(const TetMesh& mesh, const std::vector<int>& set) {
  const std::vector<char> before = flagsOf(mesh, set);
  std::vector<char> after = before;
  for (const auto& tet : mesh.tets)
    if (std::any_of(tet.begin(), tet.end(), [&](int node) { return before[static_cast<std::size_t>(node)]; }))
      for (const int node : tet) after[static_cast<std::size_t>(node)] = 1;
  return nodesOf(after);
}

std::vector<int> shrunkNodes(const TetMesh& mesh, const std::vector<int>& set) {
  return invertedNodes(mesh, grownNodes(mesh, invertedNodes(mesh, set)));
}

std::vector<int> connectedNodes(const TetMesh& mesh, const std::vector<int>& set) {
  std::vector<int> parent(mesh.nodes.size());
  for (std::size_t node = 0; node < parent.size(); ++node) parent[node] = static_cast<int>(node);
  const auto rootOf = [&parent](int node) {
    while (parent[node] != node) node = parent[node] = parent[parent[node]];
    return node;
  };
  for (const auto& tet : mesh.tets)
    for (int k = 1; k < 4; ++k) parent[rootOf(tet[k])] = rootOf(tet[0]);
  std::vector<char> wanted(mesh.nodes.size(), 0);
  for (const int node : set) wanted[rootOf(node)] = 1;
  std::vector<int> out = usedNodes(mesh);
  std::erase_if(out, [&](int node) { return !wanted[rootOf(node)]; });
  return out;
}

std::vector<int> invertedNodes(const TetMesh& mesh, const std::vector<int>& set) { return without(usedNodes(mesh), set); }

NearestNode nearestNode(const TetMesh& mesh, const std::vector<int>& nodes, const Vec3& place) {
  NearestNode nearest;
  for (const int node : nodes)
    if (const double distance = (mesh.nodes[node] - place).norm(); distance < nearest.distance) nearest = {node, distance};
  return nearest;
}

double halfDiagonalOf(double cellEdge) { return 0.5 * std::sqrt(3.0) * (1 + 1e-9) * cellEdge; }

double meanCellEdge(const TetMesh& mesh) {
  if (mesh.tets.empty()) return 0;
  double volume = 0;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t) volume += std::abs(tetVolume(mesh, static_cast<int>(t)));
  return plain::cubeRoot(6 * volume / static_cast<double>(mesh.tets.size()));
}

}  // namespace glenoid
