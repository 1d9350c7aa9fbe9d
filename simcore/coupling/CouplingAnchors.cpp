// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/coupling/CouplingAnchors.h"

#include <algorithm>
#include <cstdio>

#include "simcore/coupling/RegionAnchors.h"
#include "simcore/embed/Bind.h"

namespace glenoid {
namespace {

using Anchors = std::vector<CouplingAnchor>;

Error fault(const Joint& joint, int coupling, Fault kind, Arguments arguments) {
  return {kind, {"", "/couplings/" + std::to_string(coupling), joint.couplings[coupling].id, {}}, std::move(arguments), ""};
}

std::string threeDigits(double value) {
  char text[32];
  std::snprintf(text, sizeof text, "%.3g", value);
  return text;
}

Result<Anchors> overRegion(const Joint& joint, int index, const CoupledPart& a, const Part& b) {
  const Coupling& coupling = joint.couplings[index];
  if (coupling.regionA.empty()) return fault(joint, index, Fault::BadNodes, {"neither"});
  const Region* region = findRegion(*a.part, coupling.regionA);
  if (!region) return fault(joint, index, Fault::UnknownId, {coupling.regionA, "region"});
  if (const AreaMoments moments = momentsOf(*a.part, *region); !canHold(moments)) {
    const Vec3 radii = radiiOfGyration(moments);
    return fault(joint, index, Fault::TooFewSprings, {threeDigits(1e6 * moments.area), threeDigits(1e3 * radii(2)), threeDigits(1e3 * radii(1))});
  }
  Anchors anchors;
  for (const RegionAnchor& anchor : regionAnchors(a, *region, &b, joint.axes_W))
    anchors.push_back({anchor.rest_W, anchor.binding, coupling.stiffnessPerArea * anchor.share});
  return anchors;
}

/// A node as a point of its own mesh: weight one, in the first tetrahedron that has it.
std::vector<VertexBinding> bindToNodes(const TetMesh& mesh, const std::vector<int>& nodes) {
  std::vector<int> tetOf(mesh.nodes.size(), -1);
  for (std::size_t t = mesh.tets.size(); t-- > 0;)
    for (const int node : mesh.tets[t]) tetOf[node] = static_cast<int>(t);
  std::vector<VertexBinding> bound;
  for (const int node : nodes) {
    VertexBinding& at = bound.emplace_back();
    if (tetOf[node] < 0) {  // of no tetrahedron: moved by none, so it is a place as any other
      at = bindToTets(mesh, std::span(&mesh.nodes[node], 1)).front();
      continue;
    }
    at.node = mesh.tets[tetOf[node]];
    for (int k = 0; k < 4; ++k) at.weight[k] = at.node[k] == node ? 1 : 0;
  }
  return bound;
}

Result<Anchors> atNodes(const Joint& joint, int index, const CoupledPart& a) {
  const Coupling& coupling = joint.couplings[index];
  const auto bad = [&](Arguments why) { return fault(joint, index, Fault::BadNodes, std::move(why)); };
  if (!coupling.regionA.empty()) return bad({"both"});
  if (a.part->kind != PartKind::Soft || !a.part->volume) return bad({"rigid", coupling.partA});
  const TetMesh& numbered = a.authored ? *a.authored : *a.part->volume;
  const int size = static_cast<int>(numbered.nodes.size());
  std::vector<Vec3> places;
  for (const int node : coupling.nodesA) {
    if (node < 0 || node >= size) return bad({"outside", std::to_string(node), std::to_string(size - 1)});
    places.push_back(numbered.nodes[node]);
  }
  std::vector<int> sorted = coupling.nodesA;
  std::sort(sorted.begin(), sorted.end());
  if (const auto same = std::adjacent_find(sorted.begin(), sorted.end()); same != sorted.end()) return bad({"twice", std::to_string(*same)});
  const std::string count = std::to_string(places.size());
  if (places.size() < 3) return bad({"few", count});
  if (!canHold(momentsOf(places))) return bad({"line", count});
  const bool own = &numbered == a.part->volume.get();
  const std::vector<VertexBinding> bound = own ? bindToNodes(numbered, coupling.nodesA) : bindToTets(*a.part->volume, places);
  Anchors anchors;
  for (std::size_t i = 0; i < places.size(); ++i) anchors.push_back({places[i], bound[i], coupling.stiffnessPerNode});
  return anchors;
}

}  // namespace

AreaMoments momentsOf(std::span<const Vec3> points_W) {
  AreaMoments moments;
  moments.area = static_cast<double>(points_W.size());
  if (points_W.empty()) return moments;
  for (const Vec3& x : points_W) moments.centre += (x - points_W[0]) / moments.area;
  moments.centre += points_W[0];
  for (const Vec3& x : points_W) moments.second += (x - moments.centre) * (x - moments.centre).transpose();
  return moments;
}

Result<Anchors> couplingAnchors(const Joint& joint, int coupling, const CoupledPart& a, const Part& b) {
  return joint.couplings[coupling].byNodes() ? atNodes(joint, coupling, a) : overRegion(joint, coupling, a, b);
}

}  // namespace glenoid
