// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "simcore/check/CheckParts.h"
#include "simcore/coupling/BondLimit.h"
#include "simcore/coupling/Islands.h"
#include "simcore/coupling/RegionAnchors.h"
#include "simcore/coupling/Springs.h"
#include "simcore/scene/CouplingHold.h"
#include "simcore/scene/ProposeExclusions.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid::check {
namespace {

double distanceBetween(const Part& a, const Part& b) {
  const TriangleTree tree(*b.collision);
  double least = std::numeric_limits<double>::infinity();
  for (const Vec3& vertex : a.collision->vertices) least = std::min(least, tree.closest(vertex, least).distance);
  return least;
}

double nearestOther(const Work& work, std::size_t part) {
  double least = std::numeric_limits<double>::infinity();
  for (std::size_t other = 0; other < work.joint.parts.size(); ++other)
    if (other != part && work.surfaces[other] && work.surfaces[part])
      least = std::min(least, distanceBetween(work.joint.parts[part], work.joint.parts[other]));
  return least;
}

}  // namespace

void checkCouplings(Work& work) {
  const Joint& joint = work.joint;
  std::vector<CoupledPart> parts;
  for (const Part& part : joint.parts) parts.push_back({&part, Vec3::Zero()});
  int least = std::numeric_limits<int>::max();
  work.report.couplings = static_cast<int>(joint.couplings.size());
  for (std::size_t c = 0; c < joint.couplings.size() && work.goesOn(); ++c) {
    const Coupling& coupling = joint.couplings[c];
    const int a = findPart(joint, coupling.partA), b = findPart(joint, coupling.partB);
    const auto add = [&](ProblemKind kind, Severity severity) -> Problem& {
      Problem& problem = work.add(kind, severity, a < 0 ? std::string() : coupling.partA);
      problem.coupling = coupling.id;
      problem.region = coupling.regionA;
      problem.other = coupling.partB;
      return problem;
    };
    if (coupling.byNodes() && a >= 0 && joint.parts[a].kind == PartKind::Soft && !work.usable[a]) continue;  // said of the part
    if (!hasHold(joint, coupling)) {
      add(ProblemKind::CouplingBroken, Severity::Error).count = static_cast<long>(coupling.nodesA.size());
      continue;
    }
    if (!work.usable[a] || !work.usable[b]) continue;
    const auto springs = deriveSprings(joint, static_cast<int>(c), parts);
    int count = 0;
    if (springs) {
      count = static_cast<int>(springs->size());
      if (const BondLimit limit = bondLimitOf(joint, coupling); limit.exceeded()) {
        Problem& problem = add(ProblemKind::RegionTooSmall, Severity::Warning);
        problem.figure = limit.area;
        problem.wanted = limit.usual;
      }
    } else if (coupling.byNodes()) {
      Problem& problem = add(ProblemKind::NodesCannotHold, Severity::Error);
      problem.count = static_cast<long>(coupling.nodesA.size());
      problem.error = springs.error();
    } else {
      // Of a strip the width is √12 radii of gyration.
      add(ProblemKind::RegionCannotHold, Severity::Error).figure =
          std::sqrt(12.0) * radiiOfGyration(momentsOf(joint.parts[a], *findRegion(joint.parts[a], coupling.regionA)))(1);
    }
    least = std::min(least, count);
  }
  work.report.springsMin = least == std::numeric_limits<int>::max() ? 0 : least;
  std::vector<std::size_t> kept;
  for (const ExclusionProposal& proposal : proposeExclusions(soundOnly(work, kept))) {
    Problem& problem = work.add(ProblemKind::BondedCollision, Severity::Note, proposal.partA);
    problem.other = proposal.partB;
    problem.figure = proposal.bonded;
  }
}

void checkIslands(Work& work) {
  const Joint& joint = work.joint;
  const std::size_t count = joint.parts.size();
  std::vector<bool> isFree(count, true);
  std::vector<char> stays(count, 0);
  std::set<std::string> fixed, held;
  if (work.scenario) {
    fixed.insert(work.scenario->fixedParts.begin(), work.scenario->fixedParts.end());
    for (const Hold& hold : work.scenario->holds) held.insert(hold.part);
    for (const Support& support : work.scenario->supports) held.insert(support.part);
  }
  for (std::size_t i = 0; i < count; ++i) {
    const Part& part = joint.parts[i];
    if (!work.scenario) {
      stays[i] = part.kind == PartKind::Rigid;
    } else {
      isFree[i] = !fixed.count(part.id);
      stays[i] = !isFree[i] || held.count(part.id);
    }
  }
  std::vector<std::array<int, 2>> joined;
  std::vector<char> coupled(count, 0);
  for (const Coupling& coupling : joint.couplings) {
    const int a = findPart(joint, coupling.partA), b = findPart(joint, coupling.partB);
    if (a < 0 || b < 0 || a == b) continue;
    joined.push_back({a, b});
    coupled[a] = coupled[b] = 1;
    if (stays[a] && !isFree[a]) stays[b] = 1;  // a fixed part joins no island, and holds what hangs on it
    if (stays[b] && !isFree[b]) stays[a] = 1;
  }
  for (const std::vector<int>& island : findCouplingIslands(isFree, joined).objects) {
    if (std::any_of(island.begin(), island.end(), [&](int part) { return stays[part]; })) continue;
    if (!work.goesOn()) return;
    const Part& first = joint.parts[island[0]];
    if (island.size() == 1) {
      work.add(ProblemKind::PartLoose, Severity::Warning, first.id).figure = nearestOther(work, island[0]);
      continue;
    }
    Problem& problem = work.add(ProblemKind::IslandLoose, Severity::Warning, first.id);
    problem.count = static_cast<long>(island.size());
    for (const int part : island) problem.parts.push_back(joint.parts[part].id);
  }
}

}  // namespace glenoid::check
