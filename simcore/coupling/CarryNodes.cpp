// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/coupling/CarryNodes.h"

#include <algorithm>
#include <cstdio>

#include "simcore/coupling/CouplingAnchors.h"
#include "simcore/coupling/RegionAnchors.h"
#include "simcore/mesh/NodePatch.h"
#include "simcore/scene/CouplingHold.h"

namespace glenoid {
namespace {

std::string millimetres(double metres) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", 1e3 * metres);
  return text;
}

}  // namespace

Result<CarriedNodes> carryNodes(Joint& joint, const std::string& id, const TetMesh& before, double cellBefore) {
  CarriedNodes carried;
  const int index = findPart(joint, id);
  if (index < 0) return carried;
  const Part& part = joint.parts[index];
  const TetMesh* after = part.volume.get();
  if (after && (after == &before || *after == before)) return carried;
  const double reach = halfDiagonalOf(std::max(cellBefore, cellEdgeOf(part)));
  const std::vector<int> offered = after ? usedNodes(*after) : std::vector<int>();
  std::vector<Coupling> couplings = joint.couplings;
  for (std::size_t c = 0; c < couplings.size(); ++c) {
    Coupling& coupling = couplings[c];
    if (!coupling.byNodes() || coupling.partA != id) continue;
    const auto bad = [&](Arguments why) {
      return Error{Fault::BadNodes, {"", "/couplings/" + std::to_string(c), coupling.id, {}}, std::move(why), "other cells"};
    };
    if (part.kind != PartKind::Soft || !after) return bad({"rigid", id});
    std::vector<int> nodes;
    std::vector<Vec3> places;
    int lost = 0;
    double farthest = 0;
    for (const int node : coupling.nodesA) {
      if (node < 0 || node >= static_cast<int>(before.nodes.size()))
        return bad({"outside", std::to_string(node), std::to_string(static_cast<int>(before.nodes.size()) - 1)});
      const NearestNode nearest = nearestNode(*after, offered, before.nodes[node]);
      lost += !(nearest.distance <= reach);
      farthest = std::max(farthest, nearest.distance);
      if (nearest.node >= 0) nodes.push_back(nearest.node);
    }
    if (lost > 0) return bad({"far", std::to_string(lost), millimetres(farthest)});
    std::sort(nodes.begin(), nodes.end());
    nodes.erase(std::unique(nodes.begin(), nodes.end()), nodes.end());
    for (const int node : nodes) places.push_back(after->nodes[node]);
    if (nodes.size() < 3) return bad({"few", std::to_string(nodes.size())});
    if (!canHold(momentsOf(places))) return bad({"line", std::to_string(nodes.size())});
    ++carried.couplings;
    carried.picked += static_cast<int>(coupling.nodesA.size());
    carried.now += static_cast<int>(nodes.size());
    carried.farthest = std::max(carried.farthest, farthest);
    if (nodes.size() < coupling.nodesA.size()) coupling.stiffnessPerNode *= static_cast<double>(coupling.nodesA.size()) / static_cast<double>(nodes.size());
    coupling.nodesA = std::move(nodes);
  }
  joint.couplings = std::move(couplings);
  return carried;
}

}  // namespace glenoid
