// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/check/FindProblems.h"

#include <algorithm>

#include "simcore/check/CheckParts.h"
#include "simcore/scene/JointFile.h"
#include "simcore/spatial/Intersect.h"

namespace glenoid {

using namespace check;

const char* problemName(ProblemKind kind) {
  switch (kind) {
    case ProblemKind::UnitOfJoint: return "unit-of-joint";
    case ProblemKind::UnitOfPart: return "unit-of-part";
    case ProblemKind::NoSurface: return "no-surface";
    case ProblemKind::SurfaceOpen: return "surface-open";
    case ProblemKind::SurfaceTangled: return "surface-tangled";
    case ProblemKind::SurfaceInwards: return "surface-inwards";
    case ProblemKind::SurfaceCutsItself: return "surface-cuts-itself";
    case ProblemKind::NoVolume: return "no-volume";
    case ProblemKind::FlatTetrahedra: return "flat-tetrahedra";
    case ProblemKind::InvertedTetrahedra: return "inverted-tetrahedra";
    case ProblemKind::NoMaterial: return "no-material";
    case ProblemKind::CouplingBroken: return "coupling-broken";
    case ProblemKind::RegionCannotHold: return "region-cannot-hold";
    case ProblemKind::NodesCannotHold: return "nodes-cannot-hold";
    case ProblemKind::RegionTooSmall: return "region-too-small";
    case ProblemKind::BondedCollision: return "bonded-collision";
    case ProblemKind::PartLoose: return "part-loose";
    case ProblemKind::IslandLoose: return "island-loose";
    case ProblemKind::WeightOverstretches: return "weight-overstretches";
    case ProblemKind::StepTooLong: return "step-too-long";
    case ProblemKind::CageUnusable: return "cage-unusable";
    case ProblemKind::CageCrushes: return "cage-crushes";
    case ProblemKind::CageMovesFar: return "cage-moves-far";
    case ProblemKind::CageSqueezes: return "cage-squeezes";
    case ProblemKind::Overlap: return "overlap";
    case ProblemKind::Swallowed: return "swallowed";
    case ProblemKind::ProofMissing: return "proof-missing";
    case ProblemKind::ProofStale: return "proof-stale";
    case ProblemKind::SettingUnused: return "setting-unused";
    case ProblemKind::Unsound: return "unsound";
  }
  return "";
}

int CheckReport::count(Severity severity) const {
  return static_cast<int>(std::count_if(problems.begin(), problems.end(),
                                        [&](const Problem& problem) { return problem.severity == severity; }));
}

Result<CheckReport> ProblemFinder::find(const Joint& joint, const Scenario* scenario, const CheckGoOn& goOn) {
  CheckReport report;
  const bool stays = scenario && !(scenario->fixedParts.empty() && scenario->holds.empty());
  Work work{joint, stays ? scenario : nullptr, goOn, report, {}, {}, m_advice};
  work.surfaces.assign(joint.parts.size(), 1);
  decltype(m_seen) seen;  // what this joint shows; the rest is forgotten
  for (std::size_t i = 0; i < joint.parts.size(); ++i) {
    const Part& part = joint.parts[i];
    for (const SurfaceKind kind : {SurfaceKind::Visual, SurfaceKind::Collision}) {
      if (!work.goesOn()) return Error{Fault::Cancelled, {}, {}, "check"};
      const auto& mesh = kind == SurfaceKind::Visual ? part.visual : part.collision;
      if (!isSound(mesh)) {
        work.surfaces[i] = 0;
        work.add(ProblemKind::NoSurface, Severity::Error, part.id).surface = kind;
        continue;
      }
      const auto known = m_seen.find(mesh);
      if (known == m_seen.end()) {
        const auto cuts = selfIntersections(*mesh);
        m_seen[mesh] = {healthOf(*mesh), static_cast<int>(cuts.size()), cuts.empty() ? -1 : cuts[0][0]};
      }
      const Seen& is = seen[mesh] = m_seen[mesh];
      report.surfaces.push_back({part.id, kind, is.health, is.cuts, is.firstCut});
      // One mesh that serves as both is said once, for what it does more harm as.
      if (kind == SurfaceKind::Visual && part.visual == part.collision) continue;
      checkSurface(work, report.surfaces.back());
    }
  }
  m_seen = std::move(seen);
  work.usable = work.surfaces;
  for (std::size_t i = 0; i < joint.parts.size(); ++i) {
    checkVolume(work, i);
    checkMaterials(work, joint.parts[i]);
  }
  checkUnits(work);
  checkCouplings(work);
  checkIslands(work);
  checkWeight(work);
  checkSteps(work);
  checkAtStart(work);
  if (!work.stopped) m_advice = std::move(work.adviceNow);
  if (scenario)
    for (const UnusedSetting& unused : unusedSettings(*scenario)) work.add(ProblemKind::SettingUnused, Severity::Warning).unused = unused;
  if (!work.goesOn()) return Error{Fault::Cancelled, {}, {}, "check"};
  if (report.holds())
    if (const auto sound = checkJoint(joint, {}); !sound) work.add(ProblemKind::Unsound, Severity::Error).error = sound.error();
  std::stable_sort(report.problems.begin(), report.problems.end(),
                   [](const Problem& a, const Problem& b) { return a.severity > b.severity; });
  return report;
}

std::vector<Problem> findProblems(const Joint& joint, const Scenario* scenario) {
  return ProblemFinder().find(joint, scenario)->problems;
}

}  // namespace glenoid
