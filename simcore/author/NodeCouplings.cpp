// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/author/NodeCouplings.h"

#include <algorithm>
#include <cstdio>
#include <limits>

#include "simcore/coupling/Springs.h"
#include "simcore/mesh/NodePatch.h"
#include "simcore/mesh/TrianglePatch.h"
#include "simcore/scene/CouplingHold.h"
#include "simcore/scene/RegionNear.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid {
namespace {

std::string lengthText(double metres) {
  char out[32];
  std::snprintf(out, sizeof out, "%.3g mm", 1e3 * metres);
  return out;
}

/// “foot” of cuff to humerus
std::string couplingName(const Coupling& wish) { return "“" + wish.id + "” of " + wish.partA + " to " + wish.partB; }

std::vector<int> nodesInBall(const TetMesh& mesh, std::vector<int> nodes, const NodeCoupling& wish) {
  if (wish.radius > 0) std::erase_if(nodes, [&](int node) { return (mesh.nodes[node] - wish.centre_W).norm() > wish.radius; });
  return nodes;
}

/// The nodes, or what there is instead.
struct Found {
  std::vector<int> nodes;
  std::string missed;
};

Found nearestToPoints(const TetMesh& mesh, const NodeCoupling& wish, double reach) {
  Found found;
  const std::vector<int> offered = usedNodes(mesh);
  for (std::size_t i = 0; i < wish.points_W.size(); ++i) {
    const auto [best, distance] = nearestNode(mesh, offered, wish.points_W[i]);
    if (distance <= reach) found.nodes.push_back(best);
    else if (found.missed.empty())
      found.missed = couplingName(wish.coupling) + " (point " + std::to_string(i + 1) + ": nearest node " + lengthText(distance) + ", half a cell's diagonal " + lengthText(reach) + ")";
  }
  std::sort(found.nodes.begin(), found.nodes.end());
  found.nodes.erase(std::unique(found.nodes.begin(), found.nodes.end()), found.nodes.end());
  return found;
}

Found nearToPart(const TetMesh& mesh, const TriMesh& other, const NodeCoupling& wish) {
  Found found{nodesInBall(mesh, usedNodes(mesh), wish), {}};
  if (found.nodes.empty()) {
    found.missed = couplingName(wish.coupling) + " (no node of " + wish.coupling.partA + " lies in its ball)";
    return found;
  }
  if (!wish.within) return found;
  const TriangleTree tree(other);
  const std::vector<int> near = common(pointsNear(mesh.nodes, tree, *wish.within), found.nodes);
  if (near.empty()) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const int node : found.nodes) nearest = std::min(nearest, tree.closest(mesh.nodes[node]).distance);
    found.missed = couplingName(wish.coupling) + " (nearest node " + lengthText(nearest) + ", within " + lengthText(*wish.within) + ")";
  }
  found.nodes = near;
  return found;
}

}  // namespace

Result<Done> addNodeCoupling(Joint& joint, const NodeCoupling& wish) {
  const auto fail = [&](Fault fault, Arguments arguments) {
    return Error{fault, {{}, {}, wish.coupling.id, {}}, std::move(arguments), "a coupling at nodes"};
  };
  const int a = findPart(joint, wish.coupling.partA), b = findPart(joint, wish.coupling.partB);
  if (a < 0) return fail(Fault::UnknownId, {wish.coupling.partA, "part"});
  if (b < 0) return fail(Fault::UnknownId, {wish.coupling.partB, "part"});
  const Part& part = joint.parts[a];
  if (part.kind != PartKind::Soft || !part.volume) return fail(Fault::BadNodes, {"rigid", part.id});
  const double reach = halfDiagonalOf(cellEdgeOf(part));
  Found found = wish.points_W.empty() ? nearToPart(*part.volume, *joint.parts[b].visual, wish) : nearestToPoints(*part.volume, wish, reach);
  if (!found.missed.empty()) return fail(Fault::NothingNear, {found.missed});
  Coupling coupling = wish.coupling;
  coupling.nodesA = std::move(found.nodes);
  joint.couplings.push_back(std::move(coupling));
  std::vector<CoupledPart> parts;
  for (const Part& each : joint.parts) parts.push_back({&each, Vec3::Zero()});
  if (const auto springs = deriveSprings(joint, static_cast<int>(joint.couplings.size()) - 1, parts); !springs) {
    joint.couplings.pop_back();
    return fail(springs.error().fault, springs.error().arguments);
  }
  return Done{};
}

}  // namespace glenoid
