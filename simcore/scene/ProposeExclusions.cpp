// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/scene/ProposeExclusions.h"

#include <algorithm>
#include <map>
#include <set>

#include "simcore/mesh/TrianglePatch.h"
#include "simcore/scene/CouplingHold.h"
#include "simcore/scene/RegionNear.h"

namespace glenoid {
namespace {

using Surface = std::pair<int, SurfaceKind>;  ///< part, which of its surfaces

const TriMesh* meshOf(const Joint& joint, const Surface& surface) {
  const Part& part = joint.parts[surface.first];
  return (surface.second == SurfaceKind::Visual ? part.visual : part.collision).get();
}

double wholeArea(const TriMesh& mesh) {
  return areaOf(mesh, inverted(mesh, {}));
}

}  // namespace

std::vector<ExclusionProposal> proposeExclusions(const Joint& joint, const ExclusionRules& rules) {
  // Two couplings may share triangles, so sets, not sums of areas.
  std::map<std::pair<int, int>, std::map<Surface, std::set<int>>> bonds;
  for (const Coupling& coupling : joint.couplings) {
    const int a = findPart(joint, coupling.partA), b = findPart(joint, coupling.partB);
    if (!hasHold(joint, coupling) || !joint.parts[a].visual) continue;
    const HeldSurface held = heldSurface(joint.parts[a], coupling);
    if (held.triangles.empty()) continue;
    bonds[std::minmax(a, b)][{a, held.surface}].insert(held.triangles.begin(), held.triangles.end());
  }
  std::vector<ExclusionProposal> proposals;
  for (const auto& [pair, sides] : bonds) {
    const Part& a = joint.parts[pair.first];
    const Part& b = joint.parts[pair.second];
    const bool already =
        std::any_of(joint.exclusions.begin(), joint.exclusions.end(), [&](const Exclusion& e) {
          return (e.partA == a.id && e.partB == b.id) || (e.partA == b.id && e.partB == a.id);
        });
    if (already || !a.visual || !b.visual) continue;
    ExclusionProposal proposal{a.id, b.id, 0, 0, 0};
    Surface side;
    std::vector<int> triangles;
    for (const auto& [surface, set] : sides) {
      std::vector<int> list(set.begin(), set.end());
      const double area = areaOf(*meshOf(joint, surface), list);
      if (area <= proposal.bonded) continue;
      proposal.bonded = area;
      side = surface;
      triangles = std::move(list);
    }
    if (proposal.bonded < rules.leastArea) continue;
    proposal.ofPart = proposal.bonded / std::min(wholeArea(*a.visual), wholeArea(*b.visual));
    const TriMesh& mesh = *meshOf(joint, side);
    const Part& other = side.first == pair.first ? b : a;
    const std::vector<int> near = trianglesNear(mesh, *other.visual, rules.near);
    std::vector<int> bondedNear;
    std::set_intersection(near.begin(), near.end(), triangles.begin(), triangles.end(),
                          std::back_inserter(bondedNear));
    if (const double area = areaOf(mesh, near); area > 0) proposal.ofNear = areaOf(mesh, bondedNear) / area;
    if (proposal.ofPart >= rules.partShare || proposal.ofNear >= rules.nearShare)
      proposals.push_back(proposal);
  }
  return proposals;
}

}  // namespace glenoid
