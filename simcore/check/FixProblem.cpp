// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/check/FixProblem.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <set>

#include "simcore/author/MakeCollision.h"
#include "simcore/author/SeparateStart.h"
#include "simcore/check/CheckParts.h"
#include "simcore/check/ScaleJoint.h"
#include "simcore/coupling/Springs.h"
#include "simcore/file/Vtk.h"
#include "simcore/mesh/Cleanup.h"
#include "simcore/mesh/MeshHealth.h"
#include "simcore/mesh/NodePatch.h"
#include "simcore/repair/RepairStep.h"
#include "simcore/scene/CouplingHold.h"

namespace glenoid {
namespace {

Error noLonger(const Problem& problem) {
  return {Fault::Unusable, {{}, {}, problem.part, {}}, {"the joint is no longer the one that had this problem"}, problemName(problem.kind)};
}
Error noHelp(const Problem& problem) {
  return {Fault::Unusable, {{}, {}, problem.part, {}}, {"the remedy does not help this joint"}, problemName(problem.kind)};
}

Result<Joint> turnSurface(Joint joint, const Problem& problem) {
  const int index = findPart(joint, problem.part);
  if (index < 0) return noLonger(problem);
  Part& part = joint.parts[index];
  auto& mesh = problem.surface == SurfaceKind::Visual ? part.visual : part.collision;
  if (!mesh) return noLonger(problem);
  const bool both = part.visual == part.collision;
  mesh = std::make_shared<const TriMesh>(reversed(*mesh));  // triangles keep their numbers, regions stay
  if (both) part.visual = part.collision = mesh;
  return joint;
}

/// Whether the triangles that regions name are still what they were.
bool keepsRegions(const Part& part, SurfaceKind kind, const TriMesh& before, const TriMesh& after) {
  const auto corner = [](const TriMesh& mesh, int triangle, int k) { return mesh.vertices[mesh.triangles[triangle][k]]; };
  for (const Region& region : part.regions) {
    if (region.surface != kind) continue;
    for (const int triangle : trianglesOf(region)) {
      if (triangle >= static_cast<int>(after.triangles.size()) || triangle >= static_cast<int>(before.triangles.size())) return false;
      for (int k = 0; k < 3; ++k)
        if (corner(before, triangle, k) != corner(after, triangle, k)) return false;
    }
  }
  return true;
}

/// Closes holes, drops what has no area, splits what is no manifold, cuts out where it cuts itself: as on import, in that
/// order. Not where the surface does not become sound by it, or a region would come to lie elsewhere.
Result<Joint> repairSurface(Joint joint, const Problem& problem) {
  const int index = findPart(joint, problem.part);
  if (index < 0 || !problem.surface) return noLonger(problem);
  Part& part = joint.parts[index];
  auto& mesh = problem.surface == SurfaceKind::Visual ? part.visual : part.collision;
  if (!mesh) return noLonger(problem);
  std::vector<RepairStep> steps;
  for (const RepairKind kind : {RepairKind::DropDegenerate, RepairKind::DropDuplicates, RepairKind::SplitNonManifold, RepairKind::Orient,
                                RepairKind::RemoveSelfIntersections, RepairKind::FillHoles, RepairKind::Outwards}) {
    if (kind == RepairKind::RemoveSelfIntersections && problem.kind != ProblemKind::SurfaceCutsItself) continue;
    RepairStep step;
    step.kind = kind;
    steps.push_back(step);
  }
  auto repaired = repair(*mesh, steps);
  if (!repaired) return repaired.error();
  if (!healthOf(repaired->mesh).healthy() || !keepsRegions(part, *problem.surface, *mesh, repaired->mesh)) return noHelp(problem);
  const bool both = part.visual == part.collision;
  if (both)
    for (const Region& region : part.regions)
      if (region.surface != *problem.surface && !region.triangles.empty()) return noHelp(problem);
  mesh = std::make_shared<const TriMesh>(std::move(repaired->mesh));
  if (both) part.visual = part.collision = mesh;
  return joint;
}

Result<Joint> turnTetrahedra(Joint joint, const Problem& problem) {
  const int index = findPart(joint, problem.part);
  if (index < 0 || !joint.parts[index].volume) return noLonger(problem);
  TetMesh mesh = *joint.parts[index].volume;
  for (std::size_t t = 0; t < mesh.tets.size(); ++t)
    if (tetVolume(mesh, static_cast<int>(t)) < 0) std::swap(mesh.tets[t][2], mesh.tets[t][3]);
  joint.parts[index].volume = std::make_shared<const TetMesh>(std::move(mesh));
  return joint;
}

Result<Joint> giveMaterial(Joint joint, const Problem& problem) {
  const int index = findPart(joint, problem.part);
  if (index < 0 || findMaterial(joint, problem.other) < 0) return noLonger(problem);
  std::vector<MaterialUse>& uses = joint.parts[index].materials;
  std::erase_if(uses, [&](const MaterialUse& use) { return findMaterial(joint, use.material) < 0; });
  if (uses.empty() || !uses[0].region.empty()) uses.insert(uses.begin(), {problem.other, ""});
  return joint;
}

Result<Joint> removeCoupling(Joint joint, const Problem& problem) {
  if (std::erase_if(joint.couplings, [&](const Coupling& c) { return c.id == problem.coupling; }) == 0) return noLonger(problem);
  return joint;
}

/// The region with every triangle that shares a vertex with it.
std::vector<int> grown(const TriMesh& mesh, const std::vector<int>& triangles) {
  std::vector<char> touched(mesh.vertices.size(), 0);
  for (const int triangle : triangles)
    for (const int vertex : mesh.triangles[triangle]) touched[vertex] = 1;
  std::vector<int> more;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t)
    if (std::any_of(mesh.triangles[t].begin(), mesh.triangles[t].end(), [&](int v) { return touched[v]; }))
      more.push_back(static_cast<int>(t));
  return more;
}

bool othersUse(const Joint& joint, const Part& part, const std::string& region, const std::string& coupling) {
  for (const Coupling& c : joint.couplings)
    if (c.id != coupling && c.partA == part.id && c.regionA == region) return true;
  for (const MaterialUse& use : part.materials)
    if (use.region == region) return true;
  for (const Bursa& bursa : joint.bursae)
    for (const auto* sides : {&bursa.floor, &bursa.roof})
      for (const BursaSide& side : *sides)
        if (side.part == part.id && side.region == region) return true;
  return false;
}

/// Grows the coupling's region ring by ring until it can hold; a region that others use is copied first.
Result<Joint> growRegion(Joint joint, const Problem& problem) {
  const auto found = std::find_if(joint.couplings.begin(), joint.couplings.end(),
                                  [&](const Coupling& c) { return c.id == problem.coupling; });
  if (found == joint.couplings.end()) return noLonger(problem);
  const int index = findPart(joint, found->partA);
  if (index < 0) return noLonger(problem);
  Part& part = joint.parts[index];
  const Region* old = findRegion(part, found->regionA);
  const auto& mesh = !old ? part.visual : old->surface == SurfaceKind::Visual ? part.visual : part.collision;
  if (!old || !mesh || old->triangles.empty()) return noHelp(problem);
  Region region = *old;
  if (othersUse(joint, part, region.id, found->id)) {
    do region.id += "-grown";
    while (findRegion(part, region.id));
    part.regions.push_back(region);
    found->regionA = region.id;
  }
  std::vector<CoupledPart> parts;
  for (const Part& each : joint.parts) parts.push_back({&each, Vec3::Zero()});
  std::vector<int> triangles = trianglesOf(region);
  constexpr int kRings = 8;
  for (int ring = 0; ring < kRings; ++ring) {
    triangles = grown(*mesh, triangles);
    for (Region& each : part.regions)
      if (each.id == region.id) each.triangles = runsOf(triangles);
    if (deriveSprings(joint, static_cast<int>(found - joint.couplings.begin()), parts)) return joint;
  }
  return noHelp(problem);
}

/// Gives a coupling the nodes around its own, ring by ring, until they can hold; the springs' sum stays.
Result<Joint> growNodes(Joint joint, const Problem& problem) {
  const auto found = std::find_if(joint.couplings.begin(), joint.couplings.end(),
                                  [&](const Coupling& c) { return c.id == problem.coupling; });
  if (found == joint.couplings.end() || !hasHold(joint, *found) || !found->byNodes()) return noLonger(problem);
  const Part& part = joint.parts[findPart(joint, found->partA)];
  std::vector<CoupledPart> parts;
  for (const Part& each : joint.parts) parts.push_back({&each, Vec3::Zero()});
  const double all = found->stiffnessPerNode * static_cast<double>(found->nodesA.size());
  std::sort(found->nodesA.begin(), found->nodesA.end());
  found->nodesA.erase(std::unique(found->nodesA.begin(), found->nodesA.end()), found->nodesA.end());
  constexpr int kRings = 8;
  for (int ring = 0; ring <= kRings; ++ring) {
    found->stiffnessPerNode = all / static_cast<double>(found->nodesA.size());
    if (deriveSprings(joint, static_cast<int>(found - joint.couplings.begin()), parts)) return joint;
    found->nodesA = grownNodes(*part.volume, found->nodesA);
  }
  return noHelp(problem);
}

Result<Joint> lowerStiffness(Joint joint, const Problem& problem) {
  for (Coupling& coupling : joint.couplings)
    if (coupling.id == problem.coupling && coupling.stiffnessPerArea > problem.wanted) {
      coupling.stiffnessPerArea = problem.wanted;
      return joint;
    }
  return noLonger(problem);
}

Result<Joint> excludePair(Joint joint, const Problem& problem) {
  if (findPart(joint, problem.part) < 0 || findPart(joint, problem.other) < 0) return noLonger(problem);
  const long area = std::lround(1e6 * problem.figure);
  joint.exclusions.push_back({problem.part, problem.other,
                              "bonded over " + std::to_string(area) + " mm²: couplings hold the two together"});
  return joint;
}

Result<Joint> moveHandlesBack(Joint joint, const Problem& problem) {
  for (Cage& cage : joint.cages) {
    if (cage.part != problem.part) continue;
    const double way = check::usableWay(joint, cage);
    for (std::size_t h = 0; h < cage.moved_W.size(); ++h)
      cage.moved_W[h] = way == 0 ? cage.rest_W[h] : Vec3(cage.rest_W[h] + way * (cage.moved_W[h] - cage.rest_W[h]));
    return joint;
  }
  return noLonger(problem);
}

/// Lets the cages of the soft parts of the pair give way.
Result<Joint> separate(Joint joint, const Problem& problem, const FixProgress& progress) {
  const int a = findPart(joint, problem.part), b = findPart(joint, problem.other);
  if (a < 0 || b < 0 || problem.parts.empty()) return noLonger(problem);
  StartWishes wishes;
  wishes.parts = problem.parts;
  const auto outcome = separateStart(joint, wishes, [&](double done, int) { return !progress || progress(done); });
  if (!outcome) return outcome.error();
  const std::array<int, 2> pair{std::min(a, b), std::max(a, b)};
  for (const Overlap& overlap : outcome->check.overlaps)
    if (overlap.partA == pair[0] && overlap.partB == pair[1]) return noHelp(problem);
  return joint;
}

/// Finer collision surfaces for two rigid parts, as they were tried. Not where a region lies on the ones that go.
Result<Joint> simplifyAgain(Joint joint, const Problem& problem) {
  if (!problem.rigid || problem.rigid->triangles <= 0) return noHelp(problem);
  for (const std::string& id : {problem.part, problem.other}) {
    const int index = findPart(joint, id);
    if (index < 0 || !joint.parts[index].visual) return noLonger(problem);
    Part& part = joint.parts[index];
    for (const Region& region : part.regions)
      if (region.surface == SurfaceKind::Collision) return noHelp(problem);
    auto mesh = makeCollision(*part.visual, problem.rigid->triangles);
    if (!mesh) return mesh.error();
    part.collision = std::make_shared<const TriMesh>(std::move(*mesh));
  }
  return joint;
}

Result<Joint> recordProof(Joint joint, const Problem& problem) {
  const auto start = checkStart(joint);
  if (!start) return start.error();
  if (!start->holds()) return noHelp(problem);
  joint.startProof = start->proof;
  return joint;
}

Result<Joint> removeCage(Joint joint, const Problem& problem) {
  if (std::erase_if(joint.cages, [&](const Cage& cage) { return cage.part == problem.part; }) == 0) return noLonger(problem);
  return joint;
}

}  // namespace

bool canFix(const Problem& problem) {
  switch (problem.kind) {
    case ProblemKind::UnitOfJoint:
    case ProblemKind::UnitOfPart:
    case ProblemKind::SurfaceOpen:
    case ProblemKind::SurfaceTangled:
    case ProblemKind::SurfaceInwards:
    case ProblemKind::InvertedTetrahedra:
    case ProblemKind::CouplingBroken:
    case ProblemKind::RegionCannotHold:
    case ProblemKind::NodesCannotHold:
    case ProblemKind::RegionTooSmall:
    case ProblemKind::BondedCollision:
    case ProblemKind::CageUnusable:
    case ProblemKind::CageCrushes:
    case ProblemKind::ProofMissing:
    case ProblemKind::ProofStale: return true;
    case ProblemKind::Overlap:
    case ProblemKind::Swallowed: return !problem.parts.empty() || (problem.rigid && problem.rigid->triangles > 0);
    case ProblemKind::NoMaterial: return !problem.other.empty();
    case ProblemKind::SurfaceCutsItself: return problem.surface == SurfaceKind::Collision;
    case ProblemKind::NoSurface:
    case ProblemKind::NoVolume:
    case ProblemKind::FlatTetrahedra:
    case ProblemKind::PartLoose:
    case ProblemKind::IslandLoose:
    case ProblemKind::WeightOverstretches:
    case ProblemKind::StepTooLong:
    case ProblemKind::CageMovesFar:
    case ProblemKind::CageSqueezes:
    case ProblemKind::SettingUnused:
    case ProblemKind::Unsound: return false;
  }
  return false;
}

Result<Joint> fixProblem(const Joint& joint, const Problem& problem, const FixProgress& progress) {
  switch (problem.kind) {
    case ProblemKind::UnitOfJoint: return scaledJoint(joint, problem.wanted);
    case ProblemKind::UnitOfPart:
      if (findPart(joint, problem.part) < 0) return noLonger(problem);
      return withScaledPart(joint, problem.part, problem.wanted);
    case ProblemKind::SurfaceOpen:
    case ProblemKind::SurfaceTangled:
    case ProblemKind::SurfaceCutsItself: return repairSurface(joint, problem);
    case ProblemKind::SurfaceInwards: return turnSurface(joint, problem);
    case ProblemKind::InvertedTetrahedra: return turnTetrahedra(joint, problem);
    case ProblemKind::NoMaterial: return giveMaterial(joint, problem);
    case ProblemKind::CouplingBroken: return removeCoupling(joint, problem);
    case ProblemKind::RegionCannotHold: return growRegion(joint, problem);
    case ProblemKind::NodesCannotHold: return growNodes(joint, problem);
    case ProblemKind::RegionTooSmall: return lowerStiffness(joint, problem);
    case ProblemKind::BondedCollision: return excludePair(joint, problem);
    case ProblemKind::CageUnusable: return removeCage(joint, problem);
    case ProblemKind::CageCrushes: return moveHandlesBack(joint, problem);
    case ProblemKind::Overlap:
    case ProblemKind::Swallowed: return problem.parts.empty() ? simplifyAgain(joint, problem) : separate(joint, problem, progress);
    case ProblemKind::ProofMissing: return recordProof(joint, problem);
    case ProblemKind::ProofStale: {
      // Where the start is free of overlap the proof is renewed; where it is not, the joint must not claim it.
      if (auto renewed = recordProof(joint, problem)) return renewed;
      Joint without = joint;
      without.startProof.reset();
      return without;
    }
    default: return noHelp(problem);
  }
}

}  // namespace glenoid
