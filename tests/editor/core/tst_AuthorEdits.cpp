// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/AuthorEdits.h"

#include <gtest/gtest.h>

#include <set>

#include "editor/core/PartEdits.h"
#include "editor/core/tools/Authoring.h"
#include "simcore/mesh/TrianglePatch.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

/// Everything of a joint that these edits may touch.
bool same(const Joint& a, const Joint& b) {
  if (a.couplings != b.couplings || a.exclusions != b.exclusions || a.parts.size() != b.parts.size()) return false;
  for (std::size_t i = 0; i < a.parts.size(); ++i)
    if (a.parts[i].regions != b.parts[i].regions) return false;
  return true;
}

class AuthorEditsTest : public testing::Test {
 protected:
  AuthorEditsTest() { document.open({scenes::figure4Joint(), scenes::figure4Scenario(), nullptr}, {}); }
  /// One step that undo takes back and redo makes again.
  void isOneStep(const Joint& before) {
    const Joint after = document.joint();
    EXPECT_EQ(document.undoStack().count(), 1);
    document.undoStack().undo();
    EXPECT_TRUE(same(document.joint(), before));
    document.undoStack().redo();
    EXPECT_TRUE(same(document.joint(), after));
    document.undoStack().clear();
  }
  Document document;
};

TEST_F(AuthorEditsTest, aCouplingMakesItsRegionInOneStep) {
  const Joint before = document.joint();
  CouplingWish wish{"left", "right", {}, SurfaceKind::Visual, {3, 4, 5, 9}, 2e7, 1e-3, "glued for a test"};
  const std::string id = addCoupling(document, wish);
  ASSERT_EQ(id, "left-right");
  const Coupling& made = document.joint().couplings.back();
  EXPECT_EQ(made.reason, "glued for a test");
  const Region* region = findRegion(document.joint().parts[0], made.regionA);
  ASSERT_NE(region, nullptr);
  EXPECT_EQ(trianglesOf(*region), wish.triangles);
  isOneStep(before);
  EXPECT_EQ(addCoupling(document, wish), "left-right-2") << "several couplings between one pair";
}

TEST_F(AuthorEditsTest, aColourThatNobodyChoseGoesWithTheTissue) {
  Material muscle;
  muscle.id = "muscle";
  muscle.appearance = Appearance::Muscle;
  const std::array<float, 3> chosen{0.1f, 0.2f, 0.3f};
  document.edit(QStringLiteral("colours"), {}, [&](Scene& scene) {
    scene.joint.parts[0].color = usualColor(appearanceOf(scene.joint, scene.joint.parts[0]));
    scene.joint.parts[1].color = chosen;
  });
  const std::array<float, 3> before = document.joint().parts[0].color;
  ASSERT_TRUE(setMaterial(document, document.joint().parts[0].id, muscle));
  ASSERT_TRUE(setMaterial(document, document.joint().parts[1].id, muscle));
  EXPECT_EQ(document.joint().parts[0].color, usualColor(Appearance::Muscle));
  EXPECT_EQ(document.joint().parts[1].color, chosen);
  document.undoStack().undo();
  document.undoStack().undo();
  EXPECT_EQ(document.joint().parts[0].color, before);
}

TEST_F(AuthorEditsTest, whatCannotBeDoneIsNoStep) {
  EXPECT_EQ(addCoupling(document, {"left", "left", {}, SurfaceKind::Visual, {1}, 1e7}), "");
  EXPECT_EQ(addCoupling(document, {"left", "right", {}, SurfaceKind::Visual, {}, 1e7}), "");
  EXPECT_EQ(addCoupling(document, {"left", "right", "missing", SurfaceKind::Visual, {}, 1e7}), "");
  EXPECT_EQ(addCoupling(document, {"left", "right", {}, SurfaceKind::Visual, {1}, 0}), "");
  EXPECT_FALSE(removeRegion(document, "middle", "left-end")) << "a coupling holds it";
  EXPECT_FALSE(removeCoupling(document, "missing"));
  EXPECT_FALSE(setCouplingReason(document, "c12", QString()));
  EXPECT_EQ(document.undoStack().count(), 0);
}

TEST_F(AuthorEditsTest, regionsAreMadeChangedAndRemoved) {
  Joint before = document.joint();
  const std::string id = addRegion(document, "left", QStringLiteral("Côté gauche"), SurfaceKind::Visual, {0, 1, 2});
  EXPECT_EQ(id, "c-t-gauche");
  isOneStep(before);
  before = document.joint();
  EXPECT_TRUE(setRegion(document, "left", id, SurfaceKind::Visual, {7, 8}));
  isOneStep(before);
  before = document.joint();
  EXPECT_TRUE(renameRegion(document, "left", id, QStringLiteral("Left side")));
  isOneStep(before);
  before = document.joint();
  EXPECT_TRUE(removeRegion(document, "left", id));
  isOneStep(before);
}

TEST_F(AuthorEditsTest, couplingsAreRemovedAndPairsExcluded) {
  Joint before = document.joint();
  const auto proposals = proposeExclusions(before);
  ASSERT_FALSE(proposals.empty());
  EXPECT_TRUE(excludePair(document, proposals[0]));
  EXPECT_FALSE(excludePair(document, proposals[0]));
  EXPECT_EQ(document.joint().exclusions[0].reason, "bonded over 400 mm²: couplings hold the two together");
  isOneStep(before);
  before = document.joint();
  EXPECT_TRUE(removeCoupling(document, "c12"));
  isOneStep(before);
}

TEST_F(AuthorEditsTest, contactOfAPairIsSwitchedOffAndOn) {
  const Joint before = document.joint();
  EXPECT_FALSE(setContact(document, "left", "right", true)) << "it is on";
  EXPECT_FALSE(setContact(document, "left", "left", false));
  ASSERT_TRUE(setContact(document, "left", "right", false));
  ASSERT_EQ(document.joint().exclusions.size(), 1u);
  EXPECT_FALSE(setContact(document, "right", "left", false)) << "it is off";
  isOneStep(before);
  ASSERT_TRUE(setContact(document, "right", "left", true)) << "in either order";
  EXPECT_TRUE(document.joint().exclusions.empty());
}

TEST_F(AuthorEditsTest, aPartIsPutElsewhereInOneStep) {
  const Part before = document.joint().parts[1];
  const Box3 box = boundsOf(*before.visual);
  document.edit(QStringLiteral("a proof"), {}, [](Scene& scene) { scene.joint.startProof = StartProof{}; });
  document.undoStack().clear();
  EXPECT_FALSE(movePart(document, "middle", {}));
  EXPECT_FALSE(movePart(document, "nobody", {.shift_W = Vec3(1, 0, 0)}));
  QString why;
  EXPECT_FALSE(movePart(document, "middle", {.scale = -1}, &why));
  EXPECT_FALSE(why.isEmpty());
  EXPECT_EQ(document.undoStack().count(), 0);
  // A quarter turn about Z of a box of 40 × 20 × 20 mm, half as large, 10 mm up.
  ASSERT_TRUE(movePart(document, "middle", {.turn_deg = Vec3(0, 0, 90), .scale = 0.5, .shift_W = Vec3(0, 0.01, 0)}));
  const Part after = document.joint().parts[1];
  const Box3 moved = boundsOf(*after.visual);
  EXPECT_LT((moved.sizes() - Vec3(0.01, 0.02, 0.01)).norm(), 1e-12);
  EXPECT_LT((moved.center() - (box.center() + Vec3(0, 0.01, 0))).norm(), 1e-12);
  EXPECT_LT((boundsOf(*after.collision).center() - moved.center()).norm(), 1e-9);
  EXPECT_EQ(after.regions, before.regions);
  EXPECT_NEAR(after.cellSize, before.cellSize / 2, 1e-15);
  double volume = 0, old = 0;
  for (std::size_t t = 0; t < after.volume->tets.size(); ++t) {
    volume += tetVolume(*after.volume, static_cast<int>(t)), old += tetVolume(*before.volume, static_cast<int>(t));
    EXPECT_GT(tetVolume(*after.volume, static_cast<int>(t)), 0);
  }
  EXPECT_NEAR(volume, old / 8, 1e-12 * old);
  EXPECT_FALSE(document.joint().startProof);
  ASSERT_EQ(document.undoStack().count(), 1);
  document.undoStack().undo();
  EXPECT_EQ(document.joint().parts[1].visual, before.visual) << "the very same mesh";
  EXPECT_TRUE(document.joint().startProof);
  document.undoStack().redo();
  EXPECT_EQ(document.joint().parts[1].visual, after.visual);
  // One that runs as cells gets cells that stand along the axes.
  ASSERT_TRUE(setPartElements(document, "middle", Elements::Cells));
  ASSERT_TRUE(movePart(document, "middle", {.turn_deg = Vec3(0, 30, 0)}));
  EXPECT_NE(document.joint().parts[1].volume, after.volume);
  const auto& nodes = document.joint().parts[1].volume->nodes;
  std::set<long> heights;  // of a lattice: few
  for (const Vec3& node : nodes) heights.insert(std::lround(1e6 * node.x()));
  EXPECT_LT(heights.size(), nodes.size() / 3);
}

TEST_F(AuthorEditsTest, selectionIsUndoneStepByStep) {
  DisplayState display;
  Authoring authoring(document, display);
  authoring.setTarget("middle", SurfaceKind::Visual);
  authoring.select({3}, QStringLiteral("one"));
  authoring.grow();
  const std::vector<int> ring = authoring.selected();
  EXPECT_EQ(ring, grown(*authoring.mesh(), {3}));
  authoring.invert();
  EXPECT_EQ(authoring.selected().size() + ring.size(), authoring.mesh()->triangles.size());
  authoring.invert();
  authoring.shrink();
  authoring.selectConnected();
  EXPECT_EQ(authoring.selected().size(), authoring.mesh()->triangles.size());
  QUndoStack& undo = document.undoStack();
  undo.undo();
  undo.undo();
  undo.undo();
  undo.undo();
  EXPECT_EQ(authoring.selected(), ring);
  undo.undo();
  undo.undo();
  EXPECT_TRUE(authoring.selected().empty());
  EXPECT_FALSE(undo.canUndo());
}

TEST_F(AuthorEditsTest, selectionGoesWithItsSurface) {
  DisplayState display;
  Authoring authoring(document, display);
  authoring.setTarget("middle", SurfaceKind::Collision);
  authoring.select({3, 40}, QStringLiteral("two"));
  ChangeSet changes;
  changes.parts = {"middle"};
  document.edit(QStringLiteral("another surface"), changes, [](Scene& scene) {
    scene.joint.parts[1].collision = std::make_shared<TriMesh>(scenes::boxSurface(Vec3(-0.02, 0, 0), Vec3(0.02, 0.02, 0.02), 1));
  });
  EXPECT_TRUE(authoring.selected().empty());
  while (document.undoStack().canUndo()) document.undoStack().undo();
  EXPECT_TRUE(authoring.selected().empty());
  while (document.undoStack().canRedo()) document.undoStack().redo();
  EXPECT_EQ(document.joint().parts[1].collision->triangles.size(), 12u);
  EXPECT_TRUE(authoring.selected().empty());
}

TEST(FreshId, isASlugThatIsNotTaken) {
  EXPECT_EQ(freshId("On the  Humerus!", {}), "on-the-humerus");
  EXPECT_EQ(freshId("a", {"a", "a-2"}), "a-3");
  EXPECT_EQ(freshId("→", {}), "item");
}

}  // namespace
}  // namespace glenoid
