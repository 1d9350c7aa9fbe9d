// SPDX-License-Identifier: GPL-3.0-or-later
// What an author does with picked nodes: couplings at them, other cells under them, undo.
#include <gtest/gtest.h>

#include "editor/core/AuthorEdits.h"
#include "editor/core/PartEdits.h"
#include "editor/core/tools/Authoring.h"
#include "simcore/mesh/NodePatch.h"
#include "simcore/scene/JointFile.h"
#include "tests/scenes/NodeScenes.h"

namespace glenoid {
namespace {

class NodeEdits : public testing::Test {
 protected:
  NodeEdits() { document.open({scenes::figure4AtNodes(), scenes::figure4Scenario(), nullptr}, {}); }
  /// One step that undo takes back and redo makes again, to the hash of the joint.
  void isOneStep(const std::string& before) {
    const std::string after = jointHash(document.joint());
    EXPECT_NE(after, before);
    EXPECT_EQ(document.undoStack().count(), 1);
    document.undoStack().undo();
    EXPECT_EQ(jointHash(document.joint()), before);
    document.undoStack().redo();
    EXPECT_EQ(jointHash(document.joint()), after);
    document.undoStack().clear();
  }
  std::string hash() const { return jointHash(document.joint()); }
  const Coupling& coupling(std::size_t i) const { return document.joint().couplings[i]; }
  Document document;
};

TEST_F(NodeEdits, aCouplingAtNodesIsMadeAndChangedInSteps) {
  std::string before = hash();
  CouplingWish wish;
  wish.partA = "middle";
  wish.partB = "left";
  wish.nodes = {0, 3, 9, 12};
  wish.stiffnessPerNode = 250;
  wish.reason = "sewn for a test";
  ASSERT_EQ(addCoupling(document, wish), "middle-left");
  EXPECT_EQ(coupling(2).nodesA, wish.nodes);
  EXPECT_EQ(coupling(2).stiffnessPerNode, 250);
  EXPECT_EQ(coupling(2).stiffnessPerArea, 0);
  EXPECT_TRUE(coupling(2).regionA.empty());
  EXPECT_EQ(document.joint().parts[1].regions.size(), 2u) << "no region is made";
  EXPECT_TRUE(checkJoint(document.joint(), {}).ok());
  isOneStep(before);
  before = hash();
  ASSERT_TRUE(setCouplingNodes(document, "middle-left", {0, 3, 9}));
  isOneStep(before);
  before = hash();
  document.setCouplingStiffness("middle-left", 400);
  EXPECT_EQ(coupling(2).stiffnessPerNode, 400);
  EXPECT_EQ(coupling(2).stiffnessPerArea, 0);
  isOneStep(before);
  before = hash();
  ASSERT_TRUE(setCouplingDamping(document, "middle-left", 5e-3));
  isOneStep(before);
  before = hash();
  ASSERT_TRUE(removeCoupling(document, "middle-left"));
  isOneStep(before);
}

TEST_F(NodeEdits, whatCannotHoldIsNoStep) {
  CouplingWish wish;
  wish.partA = "middle";
  wish.partB = "left";
  wish.stiffnessPerNode = 250;
  using Nodes = std::vector<int>;
  for (const Nodes& nodes : {Nodes{0, 3}, Nodes{0, 9, 18}, Nodes{0, 3, 27}, Nodes{0, 3, 3, 9}}) {
    wish.nodes = nodes;
    EXPECT_EQ(addCoupling(document, wish), "");
    EXPECT_FALSE(setCouplingNodes(document, "c12", nodes));
  }
  wish.nodes = {0, 3, 9};
  wish.stiffnessPerNode = 0;
  EXPECT_EQ(addCoupling(document, wish), "");
  wish.stiffnessPerNode = 1;
  wish.triangles = {1};
  EXPECT_EQ(addCoupling(document, wish), "") << "one way or the other";
  wish.triangles.clear();
  wish.partA = "right";
  EXPECT_EQ(addCoupling(document, wish), "") << "a rigid part has no nodes";
  EXPECT_FALSE(setCouplingNodes(document, "c12", coupling(0).nodesA)) << "they are its nodes already";
  EXPECT_EQ(document.undoStack().count(), 0);
}

TEST_F(NodeEdits, anotherBodyTakesTheNodesWithItAndSaysHowMany) {
  const std::string before = hash();
  const BodyWish wish{PartKind::Soft, 0, 0.01};
  const Body body = makeBody(document.joint().parts[1], wish).value();
  ASSERT_NE(*body.volume, *document.joint().parts[1].volume);
  QString said;
  ASSERT_TRUE(setBody(document, "middle", wish, body, &said));
  EXPECT_TRUE(said.contains(QStringLiteral("18 now 18"))) << said.toStdString();
  EXPECT_TRUE(document.undoStack().undoText().endsWith(said)) << "the history says so too";
  for (std::size_t c = 0; c < 2; ++c)
    for (const int node : coupling(c).nodesA) EXPECT_NEAR(std::abs(body.volume->nodes[node].x()), 0.02, 5e-3) << "still at the ends";
  EXPECT_TRUE(checkJoint(document.joint(), {}).ok());
  isOneStep(before);

  // Made rigid it would have no nodes: refused, with the coupling's name.
  BodyWish rigid;
  Body bone = makeBody(document.joint().parts[1], rigid).value();
  EXPECT_FALSE(setBody(document, "middle", rigid, bone, &said));
  EXPECT_TRUE(said.contains(QStringLiteral("c12"))) << said.toStdString();
  QString why;
  EXPECT_FALSE(setPartKind(document, "middle", PartKind::Rigid, {}, 0, &why));
  EXPECT_EQ(why, said);
  EXPECT_EQ(document.undoStack().count(), 0);
}

TEST_F(NodeEdits, cellsWithoutNodesNearAreRefused) {
  QString why;
  const auto away = std::make_shared<const TetMesh>(scenes::boxVolume(Vec3(-0.02, 0.1, 0), Vec3(0.02, 0.12, 0.02), 2, 2, 2));
  EXPECT_FALSE(setPartVolume(document, "middle", away, 0.02, &why));
  EXPECT_TRUE(why.contains(QStringLiteral("c12"))) << why.toStdString();
  EXPECT_EQ(document.undoStack().count(), 0);
  const auto finer = std::make_shared<const TetMesh>(scenes::boxVolume(Vec3(-0.02, 0, 0), Vec3(0.02, 0.02, 0.02), 4, 4, 4));
  const std::string before = hash();
  EXPECT_TRUE(setPartVolume(document, "middle", finer, 0.01, &why));
  EXPECT_NE(coupling(0).nodesA, scenes::figure4AtNodes().couplings[0].nodesA);
  for (const int node : coupling(0).nodesA) EXPECT_NEAR(finer->nodes[node].x(), -0.02, 1e-12);
  isOneStep(before);
}

TEST_F(NodeEdits, aPartThatMovesKeepsItsNodes) {
  std::string before = hash();
  const auto nodes = coupling(0).nodesA;
  ASSERT_TRUE(movePart(document, "middle", {.turn_deg = Vec3(0, 0, 30), .scale = 1.5, .shift_W = Vec3(0.01, 0, 0)}));
  EXPECT_EQ(coupling(0).nodesA, nodes) << "its tetrahedra are the same";
  isOneStep(before);
  // One that runs as cells is cut anew: its nodes are those of the new cells that lie where the old ones went.
  document.open({scenes::figure4AtNodes(), scenes::figure4Scenario(), nullptr}, {});
  ASSERT_TRUE(setPartElements(document, "middle", Elements::Cells));
  document.undoStack().clear();
  before = hash();
  const PartMove move{.turn_deg = Vec3(0, 0, 90)};
  const PartMap map = partMap(document.joint().parts[1], move);
  QString why;
  ASSERT_TRUE(movePart(document, "middle", move, &why)) << why.toStdString();
  const TetMesh& cells = *document.joint().parts[1].volume;
  for (const int node : coupling(0).nodesA) EXPECT_LT(std::abs(cells.nodes[node].y() - map.point(Vec3(-0.02, 0, 0)).y()), 0.0174) << "the end that was the left one";
  isOneStep(before);
}

TEST_F(NodeEdits, aSelectionOfNodesIsUndoneStepByStep) {
  DisplayState display;
  Authoring authoring(document, display);
  authoring.setTarget("middle", SurfaceKind::Visual);
  authoring.select({3}, QStringLiteral("a triangle"));
  authoring.setPicking(Authoring::Picking::Nodes);
  EXPECT_EQ(document.undoStack().count(), 1) << "what is picked is no edit";
  const TetMesh& cells = *authoring.cells();
  authoring.selectNodes({13}, QStringLiteral("the middle one"));
  authoring.grow();
  const std::vector<int> ring = authoring.selectedNodes();
  EXPECT_EQ(ring, grownNodes(cells, {13}));
  authoring.invert();
  EXPECT_EQ(authoring.selectedNodes().size() + ring.size(), cells.nodes.size());
  authoring.invert();
  authoring.shrink();
  EXPECT_EQ(authoring.selectedNodes(), shrunkNodes(cells, ring));
  authoring.selectNodes({0}, QStringLiteral("a corner"));
  authoring.selectConnected();
  EXPECT_EQ(authoring.selectedNodes().size(), cells.nodes.size());
  authoring.clear();
  EXPECT_FALSE(authoring.anySelected());
  EXPECT_EQ(authoring.selected(), std::vector<int>{3}) << "triangles have a selection of their own";
  QUndoStack& undo = document.undoStack();
  for (int i = 0; i < 6; ++i) undo.undo();
  EXPECT_EQ(authoring.selectedNodes(), ring);
  undo.undo();
  undo.undo();
  EXPECT_TRUE(authoring.selectedNodes().empty());
  undo.undo();
  EXPECT_EQ(authoring.picking(), Authoring::Picking::Triangles) << "what was picked when that step was made";
  EXPECT_TRUE(authoring.selected().empty());
  undo.redo();
  undo.redo();
  EXPECT_EQ(authoring.picking(), Authoring::Picking::Nodes);
  EXPECT_EQ(authoring.selectedNodes(), std::vector<int>{13});
  EXPECT_EQ(undo.count(), 9);
}

TEST_F(NodeEdits, selectedNodesGoWithTheirCells) {
  DisplayState display;
  Authoring authoring(document, display);
  authoring.setTarget("middle", SurfaceKind::Visual);
  authoring.select({3, 40}, QStringLiteral("two"));
  authoring.selectNodes({1, 26}, QStringLiteral("two nodes"));
  authoring.setTarget("middle", SurfaceKind::Collision);
  EXPECT_EQ(authoring.selectedNodes(), (std::vector<int>{1, 26})) << "they lie on neither surface";
  ASSERT_TRUE(setPartVolume(document, "middle", std::make_shared<const TetMesh>(scenes::boxVolume(Vec3(-0.02, 0, 0), Vec3(0.02, 0.02, 0.02), 1, 1, 1)), 0.04));
  EXPECT_TRUE(authoring.selectedNodes().empty());
  while (document.undoStack().canUndo()) document.undoStack().undo();
  while (document.undoStack().canRedo()) document.undoStack().redo();
  for (const int node : authoring.selectedNodes()) EXPECT_LT(node, 8);
  authoring.setTarget("left", SurfaceKind::Visual);
  EXPECT_EQ(authoring.cells(), nullptr);
  authoring.grow();
  authoring.invert();
  EXPECT_TRUE(authoring.selectedNodes().empty()) << "a rigid part has none";
}

TEST(NodePatch, neighboursShareATetrahedron) {
  TetMesh mesh;
  mesh.nodes = {Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0), Vec3(0, 0, 1), Vec3(1, 1, 1), Vec3(5, 5, 5), Vec3(6, 5, 5), Vec3(5, 6, 5), Vec3(5, 5, 6), Vec3(9, 9, 9)};
  mesh.tets = {{0, 1, 2, 3}, {1, 2, 3, 4}, {5, 6, 7, 8}};
  EXPECT_EQ(usedNodes(mesh), (std::vector<int>{0, 1, 2, 3, 4, 5, 6, 7, 8})) << "the last is of no tetrahedron";
  EXPECT_EQ(grownNodes(mesh, {0}), (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(grownNodes(mesh, {0, 1}), (std::vector<int>{0, 1, 2, 3, 4}));
  EXPECT_EQ(shrunkNodes(mesh, {0, 1, 2, 3}), std::vector<int>{0});
  EXPECT_EQ(connectedNodes(mesh, {4}), (std::vector<int>{0, 1, 2, 3, 4}));
  EXPECT_EQ(invertedNodes(mesh, {0, 1, 2, 3, 4}), (std::vector<int>{5, 6, 7, 8}));
  EXPECT_TRUE(grownNodes(mesh, {}).empty());
  EXPECT_EQ(meanCellEdge(TetMesh{}), 0);
  EXPECT_NEAR(meanCellEdge(scenes::boxVolume(Vec3::Zero(), Vec3(0.02, 0.02, 0.02), 2, 2, 2)), std::cbrt(6.0 / 5) * 0.01, 1e-12);
}

}  // namespace
}  // namespace glenoid
