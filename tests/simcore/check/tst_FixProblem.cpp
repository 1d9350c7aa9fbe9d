// SPDX-License-Identifier: GPL-3.0-or-later
// Each quick fix removes its problem, brings no other, and changes nothing else.
#include "simcore/check/FixProblem.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <ctime>

#include "simcore/author/Overlaps.h"
#include "simcore/check/ScaleJoint.h"
#include "simcore/mesh/Isosurface.h"
#include "simcore/mesh/Simplify.h"
#include "simcore/scene/JointFile.h"
#include "tests/scenes/NodeScenes.h"
#include "tests/simcore/check/Faults.h"

namespace glenoid {
namespace {

/// The joint after the first problem of this kind is fixed; the problem must be gone and no error may have come.
Joint fixedJoint(const Joint& joint, ProblemKind kind) {
  const auto problems = findProblems(joint);
  const Problem* problem = problemOf(problems, kind);
  EXPECT_NE(problem, nullptr) << problemName(kind);
  if (!problem) return joint;
  EXPECT_TRUE(canFix(*problem)) << problemName(kind);
  const std::string before = jointHash(joint);
  const auto fixed = fixProblem(joint, *problem);
  EXPECT_TRUE(fixed.ok()) << problemName(kind) << ": " << toLogLine(fixed.error());
  if (!fixed.ok()) return joint;
  EXPECT_EQ(jointHash(joint), before) << "the old joint is a value of its own";
  EXPECT_EQ(jointHash(*fixed), jointHash(*fixProblem(joint, *problem))) << "the same again";
  const auto after = findProblems(*fixed);
  EXPECT_FALSE(has(after, kind, problem->part)) << problemName(kind);
  for (const Problem& p : after) EXPECT_NE(p.severity, Severity::Error) << problemName(kind) << " left " << problemName(p.kind);
  return *fixed;
}

TEST(FixProblem, unitsOfTheWholeAndOfOnePart) {
  const Joint sound = soundJoint();
  const Joint back = fixedJoint(scaledJoint(sound, 1e3), ProblemKind::UnitOfJoint);
  EXPECT_NEAR(boundsOf(*back.parts[1].visual).sizes().norm(), boundsOf(*sound.parts[1].visual).sizes().norm(), 1e-12);
  EXPECT_NEAR(back.parts[1].cellSize, sound.parts[1].cellSize, 1e-12);
  const Joint one = fixedJoint(withScaledPart(sound, sound.parts[2].id, 1e3), ProblemKind::UnitOfPart);
  EXPECT_EQ(one.parts[1].visual, sound.parts[1].visual) << "the other parts keep their meshes";
}

TEST(FixProblem, scalingKeepsSharedMeshesShared) {
  Joint joint = soundJoint();
  joint.parts[0].collision = joint.parts[0].visual;
  const Joint scaled = scaledJoint(joint, 2);
  EXPECT_EQ(scaled.parts[0].collision, scaled.parts[0].visual);
}

TEST(FixProblem, surfacesAndTetrahedraAreTurned) {
  const Joint sound = soundJoint();
  Joint joint = sound;
  changeMesh(joint.parts[0].visual, [](TriMesh& m) { for (auto& t : m.triangles) std::swap(t[1], t[2]); });
  const Joint turned = fixedJoint(joint, ProblemKind::SurfaceInwards);
  EXPECT_GT(enclosedVolume(*turned.parts[0].visual), 0);
  joint = sound;
  changeMesh(softPart(joint).volume, [](TetMesh& m) {
    for (std::size_t t = 0; t < m.tets.size(); t += 3) std::swap(m.tets[t][0], m.tets[t][1]);
  });
  fixedJoint(joint, ProblemKind::InvertedTetrahedra);
}

TEST(FixProblem, openAndTangledSurfacesAreRepairedWhereRegionsStay) {
  const Joint sound = soundJoint();
  Joint joint = sound;
  changeMesh(joint.parts[0].collision, [](TriMesh& m) { m.triangles.pop_back(); });
  const Joint closed = fixedJoint(joint, ProblemKind::SurfaceOpen);
  EXPECT_NEAR(enclosedVolume(*closed.parts[0].collision), enclosedVolume(*sound.parts[0].collision), 1e-12);
  joint = sound;
  changeMesh(joint.parts[0].visual, [](TriMesh& m) { std::swap(m.triangles[0][0], m.triangles[0][1]); });
  fixedJoint(joint, ProblemKind::SurfaceTangled);

  // A repair that would move what a region names is refused: here the triangle that goes lies before it.
  joint = sound;
  const auto count = static_cast<int>(joint.parts[0].visual->triangles.size());
  joint.parts[0].regions.push_back({"last", "Last", "other", SurfaceKind::Visual, {{count, 1}}});
  changeMesh(joint.parts[0].visual, [](TriMesh& m) { m.triangles.insert(m.triangles.begin(), {0, 0, 1}); });
  const auto problems = findProblems(joint);
  const Problem* tangled = problemOf(problems, ProblemKind::SurfaceTangled);
  ASSERT_NE(tangled, nullptr);
  EXPECT_EQ(fixProblem(joint, *tangled).error().fault, Fault::Unusable);
}

TEST(FixProblem, aMissingMaterialBecomesThatOfItsKind) {
  Joint joint = soundJoint();
  joint.parts[0].materials = {{"cheese", ""}};
  EXPECT_EQ(fixedJoint(joint, ProblemKind::NoMaterial).parts[0].materials, (std::vector<MaterialUse>{{"bone", ""}}));
  softPart(joint).materials.clear();
  joint.parts[0].materials = {{"bone", ""}};
  const auto problems = findProblems(joint);
  EXPECT_FALSE(canFix(*problemOf(problems, ProblemKind::NoMaterial))) << "no other soft part to take it from";
}

TEST(FixProblem, couplingsAreRemovedOrTheirRegionsGrown) {
  Joint joint = soundJoint();
  joint.couplings[0].partB = "nobody";
  EXPECT_EQ(fixedJoint(joint, ProblemKind::CouplingBroken).couplings.size(), joint.couplings.size() - 1);

  joint = soundJoint();  // a rigid side whose one triangle is a needle of a micrometre
  Coupling& coupling = joint.couplings[0];
  const int a = findPart(joint, coupling.partA);
  ASSERT_EQ(joint.parts[a].kind, PartKind::Soft);
  Part& rigid = joint.parts[findPart(joint, coupling.partB)];
  rigid.regions.push_back({"spot", "Spot", "other", SurfaceKind::Visual, {{0, 1}}});
  changeMesh(rigid.visual, [](TriMesh& m) {
    const auto t = m.triangles[0];
    const Vec3 side = m.vertices[t[1]] - m.vertices[t[0]], other = m.vertices[t[2]] - m.vertices[t[0]];
    m.vertices[t[2]] = m.vertices[t[0]] + 0.5 * side + 1e-6 * other.normalized();
  });
  std::swap(coupling.partA, coupling.partB);
  coupling.regionA = "spot";
  const std::string part = coupling.partA, region = coupling.regionA, id = coupling.id;
  const Joint grown = fixedJoint(joint, ProblemKind::RegionCannotHold);
  EXPECT_GT(trianglesOf(*findRegion(grown.parts[findPart(grown, part)], region)).size(), 1u);

  // A region that something else uses stays as it is.
  Bursa bursa;
  bursa.id = "sac";
  bursa.floor = {{part, region}};
  bursa.roof = {{softPart(joint).id, ""}};
  joint.bursae = {bursa};
  const Joint copied = fixedJoint(joint, ProblemKind::RegionCannotHold);
  EXPECT_EQ(trianglesOf(*findRegion(copied.parts[findPart(copied, part)], region)).size(), 1u);
  for (const Coupling& c : copied.couplings)
    if (c.id == id) {
      EXPECT_EQ(c.regionA, region + "-grown");
    }
}

TEST(FixProblem, nodesThatCannotHoldGetThoseAroundThem) {
  Joint joint = soundJoint();
  joint.couplings = scenes::figure4AtNodes().couplings;
  using Nodes = std::vector<int>;
  for (const Nodes& nodes : {Nodes{0}, Nodes{0, 3}, Nodes{0, 3, 6}}) {
    joint.couplings[0].nodesA = nodes;
    joint.couplings[0].stiffnessPerNode = 600 / static_cast<double>(nodes.size());
    const Joint fixed = fixedJoint(joint, ProblemKind::NodesCannotHold);
    const Coupling& coupling = fixed.couplings[0];
    EXPECT_GT(coupling.nodesA.size(), nodes.size());
    EXPECT_NEAR(coupling.stiffnessPerNode * static_cast<double>(coupling.nodesA.size()), 600, 1e-9) << "as stiff in all";
    for (const int node : nodes) EXPECT_EQ(std::count(coupling.nodesA.begin(), coupling.nodesA.end(), node), 1);
  }
  joint.couplings[0].nodesA = {0, 3, 3, 9};  // named twice: the rest holds
  EXPECT_EQ(fixedJoint(joint, ProblemKind::NodesCannotHold).couplings[0].nodesA, (std::vector<int>{0, 3, 9}));
  joint.couplings[0].nodesA = {0, 3, 99};
  EXPECT_EQ(fixedJoint(joint, ProblemKind::CouplingBroken).couplings.size(), 1u);
}

TEST(FixProblem, aBondStifferThanTissueIsMadeAsStiffAsAMillimetreOfIt) {
  Joint joint = soundJoint();
  joint.couplings[0].stiffnessPerArea = 1e10;
  for (Region& region : softPart(joint).regions)
    if (region.id == joint.couplings[0].regionA) region.triangles = {{trianglesOf(region)[0], 1}};
  const Joint fixed = fixedJoint(joint, ProblemKind::RegionTooSmall);
  EXPECT_NEAR(fixed.couplings[0].stiffnessPerArea, 5e7, 1);
  EXPECT_FALSE(has(findProblems(fixed), ProblemKind::RegionTooSmall));
}

TEST(FixProblem, contactOfABondIsSwitchedOff) {
  Joint joint = soundJoint();
  joint.exclusions.clear();
  const auto problems = findProblems(joint);
  const Problem* bond = problemOf(problems, ProblemKind::BondedCollision);
  ASSERT_NE(bond, nullptr);
  const auto fixed = fixProblem(joint, *bond);
  ASSERT_TRUE(fixed.ok());
  ASSERT_EQ(fixed->exclusions.size(), 1u);
  EXPECT_NE(fixed->exclusions[0].reason.find("mm²"), std::string::npos);
  for (const Problem& left : findProblems(*fixed))
    EXPECT_FALSE(left.kind == ProblemKind::BondedCollision && left.part == bond->part && left.other == bond->other);
}

TEST(FixProblem, handlesAreMovedBackAsFarAsNeeded) {
  Joint joint = soundJoint();
  joint.cages = {boxCage(softPart(joint), 2e-3)};
  const Box3 box = boundsOf(*softPart(joint).visual);
  for (Vec3& handle : joint.cages[0].moved_W) handle.y() = box.center().y() + 0.05 * (handle.y() - box.center().y());
  const Joint fixed = fixedJoint(joint, ProblemKind::CageCrushes);
  EXPECT_NE(fixed.cages[0].moved_W, fixed.cages[0].rest_W) << "not farther than needed";
  Joint broken = soundJoint();
  broken.cages = {boxCage(softPart(broken), 2e-3)};
  broken.cages[0].triangles.pop_back();
  broken.cages[0].moved_W[0].y() += 1e-3;
  EXPECT_TRUE(fixedJoint(broken, ProblemKind::CageUnusable).cages.empty());
}

TEST(FixProblem, overlapsAreSeparatedByCagesAndProven) {
  Joint joint = scenes::blockOnPlateJoint();
  Part& block = softPart(joint);
  const auto lower = [](auto& points) { for (Vec3& x : points) x.y() -= 1.5e-3; };
  changeMesh(block.visual, [&](TriMesh& m) { lower(m.vertices); });
  changeMesh(block.collision, [&](TriMesh& m) { lower(m.vertices); });
  changeMesh(block.volume, [&](TetMesh& m) { lower(m.nodes); });
  const Joint fixed = fixedJoint(joint, ProblemKind::Overlap);
  ASSERT_TRUE(fixed.startProof.has_value());
  EXPECT_EQ(fixed.startProof->cuts, 0);
  EXPECT_EQ(fixed.startProof->of, startHash(fixed));
  // The same can be stopped, and then gives nothing.
  const auto problems = findProblems(joint);
  const auto stopped = fixProblem(joint, *problemOf(problems, ProblemKind::Overlap), [](double) { return false; });
  ASSERT_FALSE(stopped.ok());
  EXPECT_EQ(stopped.error().fault, Fault::Cancelled);
}

/// A ball in half a shell with 0.5 mm of room, in too few triangles to keep it.
Joint coarseHip() {
  Joint joint;
  joint.id = joint.name = "hip";
  scenes::addMaterials(joint);
  const auto add = [&](const char* id, const ScalarField& field) {
    Part part;
    part.id = part.name = id;
    part.number = static_cast<int>(joint.parts.size()) + 1;
    part.materials = {{"bone", ""}};
    part.visual = std::make_shared<const TriMesh>(isosurface(field, Box3(Vec3::Constant(-0.033), Vec3::Constant(0.033)), 0.0025));
    part.collision = std::make_shared<const TriMesh>(*simplify(*part.visual, 200));
    joint.parts.push_back(part);
  };
  add("cup", [](const Vec3& p) { return std::max({p.norm() - 0.03, 0.0245 - p.norm(), p.y() - 0.002}); });
  add("ball", [](const Vec3& p) { return p.norm() - 0.024; });
  return joint;
}

TEST(FixProblem, bonesTooCoarseForTheirGapAreSimplifiedAgain) {
  const Joint joint = coarseHip();
  ProblemFinder finder;
  const auto found = finder.find(joint);
  ASSERT_TRUE(found.ok());
  const Problem* overlap = problemOf(found->problems, ProblemKind::Overlap);
  ASSERT_NE(overlap, nullptr) << "the case itself";
  EXPECT_TRUE(overlap->parts.empty());
  ASSERT_TRUE(overlap->rigid);
  ASSERT_GT(overlap->rigid->triangles, 200);
  ASSERT_TRUE(canFix(*overlap));
  const auto fixed = fixProblem(joint, *overlap);
  ASSERT_TRUE(fixed.ok()) << toLogLine(fixed.error());
  EXPECT_FALSE(has(findProblems(*fixed), ProblemKind::Overlap)) << "what is advised holds";
  EXPECT_EQ(fixed->parts[0].visual, joint.parts[0].visual);

  // Looked at again nothing is tried again.
  const std::clock_t begin = std::clock();
  const auto again = finder.find(joint);
  EXPECT_LT(static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC, 1.0);
  EXPECT_EQ(problemOf(again->problems, ProblemKind::Overlap)->rigid, overlap->rigid);

  Joint painted = joint;
  painted.parts[0].regions.push_back({"rim", "", "", SurfaceKind::Collision, {{0, 3}}});
  EXPECT_FALSE(fixProblem(painted, *overlap).ok()) << "a region would lie elsewhere";
}

TEST(FixProblem, theProofIsRecordedOrRenewed) {
  Joint joint = scenes::blockOnPlateJoint();
  joint.cages = {boxCage(softPart(joint), 2e-3)};
  const Joint proven = fixedJoint(joint, ProblemKind::ProofMissing);
  ASSERT_TRUE(proven.startProof.has_value());
  EXPECT_EQ(proven.startProof->of, startHash(proven));
  Joint stale = proven;
  stale.cages[0].moved_W[0].y() += 1e-3;
  EXPECT_EQ(fixedJoint(stale, ProblemKind::ProofStale).startProof->of, startHash(stale));
}

TEST(FixProblem, aJointThatChangedMeanwhileIsRefused) {
  Joint joint = soundJoint();
  joint.parts[0].materials.clear();
  const auto problems = findProblems(joint);
  Joint other = joint;
  other.parts.erase(other.parts.begin());
  const auto refused = fixProblem(other, *problemOf(problems, ProblemKind::NoMaterial));
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().fault, Fault::Unusable);
}

}  // namespace
}  // namespace glenoid
