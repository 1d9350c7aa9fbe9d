// SPDX-License-Identifier: GPL-3.0-or-later
// Springs at picked nodes: where they hold, what they weigh, and what cannot hold.
#include <gtest/gtest.h>

#include <random>

#include "simcore/coupling/BondLimit.h"
#include "simcore/coupling/CouplingAnchors.h"
#include "simcore/coupling/CouplingFigures.h"
#include "simcore/embed/Bind.h"
#include "simcore/scene/CouplingHold.h"
#include "tests/scenes/NodeScenes.h"

namespace glenoid {
namespace {

std::vector<CoupledPart> coupledParts(const Joint& joint) {
  std::vector<CoupledPart> parts;
  for (const Part& part : joint.parts) parts.push_back({&part, boundsOf(*part.visual).center()});
  return parts;
}

/// Why these nodes cannot hold figure 4's left end; empty: they can.
Arguments whyNot(const std::vector<int>& nodes) {
  Joint joint = scenes::figure4AtNodes();
  joint.couplings[0].nodesA = nodes;
  const auto springs = deriveSprings(joint, 0, coupledParts(joint));
  if (springs.ok()) return {};
  EXPECT_EQ(springs.error().fault, Fault::BadNodes);
  EXPECT_EQ(springs.error().place.part, "c12");
  EXPECT_EQ(springs.error().place.pointer, "/couplings/0");
  return springs.error().arguments;
}

TEST(NodeAnchors, eachPickedNodeIsHeldByOneSpringAtItself) {
  Joint joint = scenes::figure4AtNodes();
  Coupling& coupling = joint.couplings[0];
  std::reverse(coupling.nodesA.begin(), coupling.nodesA.end());
  coupling.damping = 3e-3;
  const auto parts = coupledParts(joint);
  const auto springs = deriveSprings(joint, 0, parts).value();
  const TetMesh& volume = *joint.parts[1].volume;
  ASSERT_EQ(springs.size(), 9u);
  for (std::size_t i = 0; i < springs.size(); ++i) {
    const CouplingSpring& spring = springs[i];
    const Vec3& node = volume.nodes[coupling.nodesA[i]];
    EXPECT_EQ(boundPosition(spring.a, volume.nodes), node) << "to the last bit";
    EXPECT_LT((parts[0].centre + spring.b.r_B - node).norm(), 1e-16);
    EXPECT_EQ(spring.stiffness, coupling.stiffnessPerNode);
    EXPECT_DOUBLE_EQ(spring.damping, 3e-3 * coupling.stiffnessPerNode);
    double own = 0;
    for (int k = 0; k < 4; ++k) own += spring.a.node[k] == coupling.nodesA[i] ? spring.a.weight[k] : 0;
    EXPECT_EQ(own, 1);
  }
}

TEST(NodeAnchors, aSoftPartnerHoldsByTheTetrahedronAround) {
  Joint joint = scenes::figure4AtNodes();
  joint.parts[2] = scenes::boxPart("right", 3, PartKind::Soft, Vec3(0.015, -0.003, -0.004), Vec3(0.05, 0.025, 0.03), 3);
  const TetMesh& b = *joint.parts[2].volume;
  for (const CouplingSpring& spring : deriveSprings(joint, 1, coupledParts(joint)).value()) {
    double sum = 0;
    for (int k = 0; k < 4; ++k) {
      EXPECT_GE(spring.b.weight[k], -1e-12) << "inside";
      sum += spring.b.weight[k];
    }
    EXPECT_NEAR(sum, 1, 1e-14);
    EXPECT_LT((boundPosition(spring.a, joint.parts[1].volume->nodes) - boundPosition(spring.b, b.nodes)).norm(), 1e-16);
  }
}

TEST(NodeAnchors, forcesAndMomentsOfBothSidesBalance) {
  // Both sides deformed at random: what the springs do to the nodes of A and of B sums to nothing, about any point.
  Joint joint = scenes::figure4AtNodes();
  joint.parts[2] = scenes::boxPart("right", 3, PartKind::Soft, Vec3(0.015, -0.003, -0.004), Vec3(0.05, 0.025, 0.03), 3);
  std::mt19937 random(5);
  std::uniform_real_distribution<double> some(-0.01, 0.01);
  std::vector<Vec3> a = joint.parts[1].volume->nodes, b = joint.parts[2].volume->nodes;
  for (auto* nodes : {&a, &b})
    for (Vec3& x : *nodes) x += Vec3(some(random), some(random), some(random));
  Vec3 force = Vec3::Zero(), moment = Vec3::Zero();
  double size = 0;
  for (const CouplingSpring& spring : deriveSprings(joint, 1, coupledParts(joint)).value()) {
    const Vec3 onA = -spring.stiffness * (boundPosition(spring.a, a) - boundPosition(spring.b, b));
    size += onA.norm();
    for (int k = 0; k < 4; ++k) {
      force += spring.a.weight[k] * onA - spring.b.weight[k] * onA;
      moment += a[spring.a.node[k]].cross(spring.a.weight[k] * onA) - b[spring.b.node[k]].cross(spring.b.weight[k] * onA);
    }
  }
  EXPECT_GT(size, 10);
  EXPECT_LT(force.norm(), 1e-14 * size);
  EXPECT_LT(moment.norm(), 1e-15 * size) << "on arms of centimetres";
}

TEST(NodeAnchors, aNodeIsAPlaceWhereAnotherMeshRuns) {
  Joint joint = scenes::figure4AtNodes();
  const TetMesh authored = *joint.parts[1].volume;
  joint.parts[1].volume = std::make_shared<TetMesh>(scenes::boxVolume(Vec3(-0.02, 0, 0), Vec3(0.02, 0.02, 0.02), 3, 3, 3));
  auto parts = coupledParts(joint);
  parts[1].authored = &authored;
  const auto springs = deriveSprings(joint, 0, parts).value();
  ASSERT_EQ(springs.size(), 9u);
  for (std::size_t i = 0; i < springs.size(); ++i)
    EXPECT_LT((boundPosition(springs[i].a, joint.parts[1].volume->nodes) - authored.nodes[joint.couplings[0].nodesA[i]]).norm(), 1e-16);
}

TEST(NodeAnchors, whatCannotHoldIsSaid) {
  const std::vector<int> face = scenes::figure4AtNodes().couplings[0].nodesA;
  const Part middle = scenes::figure4Joint().parts[1];
  EXPECT_EQ(whyNot({face[0], face[1]}), (Arguments{"few", "2"}));
  EXPECT_EQ(whyNot({face[3]}), (Arguments{"few", "1"}));
  const auto edge = scenes::nodesWhere(middle, [](const Vec3& p) { return std::abs(p.y()) + std::abs(p.z()) < 1e-9; });
  ASSERT_EQ(edge.size(), 3u);
  EXPECT_EQ(whyNot(edge), (Arguments{"line", "3"}));
  EXPECT_EQ(whyNot({edge[0], edge[1], edge[1], face[8]}), (Arguments{"twice", std::to_string(edge[1])}));
  EXPECT_EQ(whyNot({0, 1, 27}), (Arguments{"outside", "27", "26"}));
  EXPECT_EQ(whyNot({0, 1, -1}), (Arguments{"outside", "-1", "26"}));
  EXPECT_EQ(whyNot({edge[0], edge[1], face[8]}), Arguments{}) << "a triangle holds";
  Joint joint = scenes::figure4AtNodes();
  joint.couplings[0].regionA = "left-end";
  EXPECT_EQ(deriveSprings(joint, 0, coupledParts(joint)).error().arguments, (Arguments{"both"}));
  joint = scenes::figure4AtNodes();
  std::swap(joint.couplings[0].partA, joint.couplings[0].partB);
  EXPECT_EQ(deriveSprings(joint, 0, coupledParts(joint)).error().arguments, (Arguments{"rigid", "left"}));
  joint = scenes::figure4AtNodes();
  joint.couplings[0].nodesA.clear();
  EXPECT_EQ(deriveSprings(joint, 0, coupledParts(joint)).error().arguments, (Arguments{"neither"}));
}

TEST(NodeAnchors, aHairsBreadthBesideALineIsALine) {
  // The rule of regions: a second radius of gyration of a thousandth of the first.
  const auto holds = [](double off) {
    const std::vector<Vec3> points{Vec3(0, 0, 0), Vec3(0.01, off, 0), Vec3(0.02, 0, 0)};
    Joint joint = scenes::figure4AtNodes();
    TetMesh mesh = *joint.parts[1].volume;
    for (int i = 0; i < 3; ++i) mesh.nodes[i] = points[i];
    auto parts = coupledParts(joint);
    joint.couplings[0].nodesA = {0, 1, 2};
    parts[1].authored = &mesh;
    return deriveSprings(joint, 0, parts).ok();
  };
  EXPECT_FALSE(holds(1.6e-5));
  EXPECT_TRUE(holds(1.8e-5)) << "√3 thousandths of a centimetre";
}

TEST(NodeFigures, areOfTheNodes) {
  Joint joint = scenes::figure4AtNodes();
  const auto figures = couplingFigures(joint, 0, {"left"});
  ASSERT_TRUE(figures.ok());
  EXPECT_EQ(figures->springs, 9);
  EXPECT_NEAR(figures->stiffness, 4e4, 1e-9);
  EXPECT_EQ(figures->anchors_W.size(), 9u);
  EXPECT_NEAR(figures->maxGap, 0, 1e-12);
  EXPECT_EQ(figures->island, 0);
  // The end face, and of the sides (4 × 40 × 20 mm) what is nearer to its nodes than to the next ones: 10 mm of 40, in squares of 10 mm whose
  // triangles have their middles at 3.3 and 6.7 mm.
  EXPECT_NEAR(figures->area, 4e-4 + 4 * 0.01 * 0.02, 1e-12);
  EXPECT_NEAR(figures->coverage, figures->area / 4e-3, 1e-9);
  TriMesh moved = *joint.parts[0].visual;
  for (Vec3& v : moved.vertices) v.x() -= 2e-3;
  joint.parts[0].visual = std::make_shared<TriMesh>(moved);
  EXPECT_NEAR(couplingFigures(joint, 0)->meanGap, 2e-3, 1e-12);
  EXPECT_EQ(islandsOfParts(joint, {"left"}), (std::vector<int>{-1, 0, 0}));
  EXPECT_DOUBLE_EQ(suggestedNodeStiffness(joint, "middle", "left"), 5e4 * joint.parts[1].cellSize);
}

TEST(NodeFigures, aNodeStandsForAFaceOfItsCells) {
  Joint joint = scenes::figure4AtNodes();
  joint.couplings[0].stiffnessPerNode = 1e9;
  const BondLimit limit = bondLimitOf(joint, joint.couplings[0]);
  EXPECT_NEAR(limit.area, 9 * 4e-4, 1e-12);
  EXPECT_DOUBLE_EQ(limit.stiffness, 9e9);
  EXPECT_DOUBLE_EQ(limit.modulus, 5e4);
  EXPECT_FALSE(limit.exceeded()) << "the cells around each give for it";
  joint.parts[1].cellSize = 0;
  EXPECT_FALSE(bondLimitOf(joint, joint.couplings[0]).exceeded()) << "also where the part does not say how large they are";
}

TEST(CouplingHold, saysWhatIsThere) {
  Joint joint = scenes::figure4AtNodes();
  EXPECT_TRUE(hasHold(joint, joint.couplings[0]));
  for (const Vec3& place : holdPlaces(joint.parts[1], joint.couplings[0])) EXPECT_NEAR(place.x(), -0.02, 1e-15);
  Coupling broken = joint.couplings[0];
  broken.nodesA.push_back(27);
  EXPECT_FALSE(hasHold(joint, broken));
  broken = joint.couplings[0];
  broken.partB = "nobody";
  EXPECT_FALSE(hasHold(joint, broken));
  broken = joint.couplings[0];
  broken.nodesA.clear();
  EXPECT_FALSE(hasHold(joint, broken));
  broken.regionA = "left-end";
  EXPECT_TRUE(hasHold(joint, broken));
  EXPECT_EQ(heldSurface(joint.parts[1], broken).triangles, trianglesOf(joint.parts[1].regions[0]));
  // Nodes within the part hold none of its surface.
  Coupling inner = joint.couplings[0];
  joint.parts[1].volume = std::make_shared<TetMesh>(scenes::boxVolume(Vec3(-0.02, 0, 0), Vec3(0.02, 0.02, 0.02), 8, 6, 6));
  inner.nodesA = scenes::nodesWhere(joint.parts[1], [](const Vec3& p) { return (p - Vec3(0, 0.01, 0.01)).norm() < 0.0034; });
  ASSERT_GE(inner.nodesA.size(), 4u);
  EXPECT_TRUE(heldSurface(joint.parts[1], inner).triangles.empty());
}

}  // namespace
}  // namespace glenoid
