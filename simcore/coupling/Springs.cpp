// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/coupling/Springs.h"

#include <Eigen/Eigenvalues>
#include <algorithm>

#include "simcore/coupling/RegionAnchors.h"
#include "simcore/embed/Bind.h"

namespace glenoid {

namespace {

using Anchor = RegionAnchor;

/// Area share of each vertex of a region, as (vertex, m²), ascending by vertex.
std::vector<std::pair<int, double>> vertexShares(const TriMesh& mesh, const Region& region) {
  std::vector<double> share(mesh.vertices.size(), 0);
  for (const int index : trianglesOf(region)) {
    const auto& t = mesh.triangles[index];
    const Vec3& x0 = mesh.vertices[t[0]];
    const double third = (mesh.vertices[t[1]] - x0).cross(mesh.vertices[t[2]] - x0).norm() / 6;
    for (const int vertex : t) share[vertex] += third;
  }
  std::vector<std::pair<int, double>> shares;
  for (std::size_t i = 0; i < share.size(); ++i)
    if (share[i] > 0) shares.push_back({static_cast<int>(i), share[i]});
  return shares;
}

std::vector<Anchor> softAnchors(const TetMesh& volume, const TriMesh& mesh, const std::vector<std::pair<int, double>>& shares) {
  std::vector<Vec3> points;
  for (const auto& [vertex, area] : shares) points.push_back(mesh.vertices[vertex]);
  const std::vector<VertexBinding> bindings = bindToTets(volume, points);
  std::vector<double> nodeShare(volume.nodes.size(), 0);
  for (std::size_t i = 0; i < shares.size(); ++i)
    for (int k = 0; k < 4; ++k)
      nodeShare[bindings[i].node[k]] += shares[i].second * std::max(0.0, bindings[i].weight[k]);
  const double least = 0.02 * *std::max_element(nodeShare.begin(), nodeShare.end());
  std::vector<Anchor> anchors;
  for (std::size_t node = 0; node < nodeShare.size(); ++node) {
    if (nodeShare[node] <= least) continue;
    VertexBinding binding;
    binding.node.fill(static_cast<int>(node));
    binding.weight = {1, 0, 0, 0};
    anchors.push_back({volume.nodes[node], binding, nodeShare[node]});
  }
  return anchors;
}

std::vector<Anchor> rigidAnchors(const Vec3& centre, const TriMesh& mesh, const std::vector<std::pair<int, double>>& shares) {
  constexpr int kMost = 12;
  std::vector<double> distance(shares.size(), 1e300);
  std::vector<Anchor> anchors;
  std::size_t next = 0;  // farthest-point sampling from the first vertex
  while (anchors.size() < std::min<std::size_t>(kMost, shares.size())) {
    const Vec3& chosen = mesh.vertices[shares[next].first];
    VertexBinding binding;
    binding.r_B = chosen - centre;
    anchors.push_back({chosen, binding, 0});
    for (std::size_t i = 0; i < shares.size(); ++i)
      distance[i] = std::min(distance[i], (mesh.vertices[shares[i].first] - chosen).norm());
    next = std::max_element(distance.begin(), distance.end()) - distance.begin();
  }
  for (const auto& [vertex, area] : shares) {
    const auto nearest = std::min_element(anchors.begin(), anchors.end(), [&, v = vertex](const Anchor& a, const Anchor& b) {
      return (a.rest_W - mesh.vertices[v]).squaredNorm() < (b.rest_W - mesh.vertices[v]).squaredNorm();
    });
    nearest->share += area;
  }
  return anchors;
}

}  // namespace

std::vector<RegionAnchor> regionAnchors(const CoupledPart& part, const Region& region) {
  const TriMesh& mesh = region.surface == SurfaceKind::Visual ? *part.part->visual : *part.part->collision;
  const auto shares = vertexShares(mesh, region);
  if (shares.empty()) return {};
  return part.part->kind == PartKind::Soft ? softAnchors(*part.part->volume, mesh, shares)
                                           : rigidAnchors(part.centre, mesh, shares);
}

bool canHold(const std::vector<RegionAnchor>& anchors) {
  if (anchors.size() < 4) return false;
  Vec3 mean = Vec3::Zero();
  for (const Anchor& anchor : anchors) mean += anchor.rest_W / static_cast<double>(anchors.size());
  Mat3 scatter = Mat3::Zero();
  for (const Anchor& anchor : anchors) scatter += (anchor.rest_W - mean) * (anchor.rest_W - mean).transpose();
  const Vec3 spread = Eigen::SelfAdjointEigenSolver<Mat3>(scatter).eigenvalues();
  return spread(1) > 1e-4 * spread(2);
}

Result<std::vector<CouplingSpring>> deriveSprings(const Joint& joint, int couplingIndex,
                                                  const std::vector<CoupledPart>& parts) {
  const Coupling& coupling = joint.couplings[couplingIndex];
  const int a = findPart(joint, coupling.partA), b = findPart(joint, coupling.partB);
  const auto fault = [&](Fault kind, Arguments arguments) {
    return Error{kind, {"", "/couplings/" + std::to_string(couplingIndex), coupling.id, {}}, std::move(arguments), ""};
  };
  if (a < 0) return fault(Fault::UnknownId, {coupling.partA, "part"});
  if (b < 0) return fault(Fault::UnknownId, {coupling.partB, "part"});
  const Part& partA = joint.parts[a];
  const Part& partB = joint.parts[b];
  const Region* region = findRegion(partA, coupling.regionA);
  if (!region) return fault(Fault::UnknownId, {coupling.regionA, "region"});

  const std::vector<RegionAnchor> anchors = regionAnchors({&partA, parts[a].centre}, *region);
  if (!canHold(anchors)) return fault(Fault::TooFewSprings, {std::to_string(anchors.size()), "4"});

  std::vector<Vec3> ends;
  double total = 0;
  for (const Anchor& anchor : anchors) {
    ends.push_back(anchor.rest_W);
    total += anchor.share;
  }
  const std::vector<VertexBinding> bound =
      partB.kind == PartKind::Soft ? bindToTets(*partB.volume, ends) : bindToRigid(ends, parts[b].centre);
  const double stiffness = coupling.stiffnessPerArea * areaOf(partA, *region);
  std::vector<CouplingSpring> springs;
  for (std::size_t i = 0; i < anchors.size(); ++i) {
    const double k = stiffness * anchors[i].share / total;
    springs.push_back({couplingIndex, a, b, anchors[i].binding, bound[i], k, coupling.damping * k});
  }
  return springs;
}

}  // namespace glenoid
