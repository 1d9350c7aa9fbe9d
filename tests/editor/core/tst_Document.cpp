// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/Document.h"

#include <gtest/gtest.h>

#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

Scene blockScene() { return {scenes::blockOnPlateJoint(), scenes::blockOnPlateScenario(), nullptr}; }

/// Remembers what a document said.
struct Listener {
  explicit Listener(Document& document) {
    QObject::connect(&document, &Document::changed, [this](const ChangeSet& changes) { heard.push_back(changes); });
  }
  std::vector<ChangeSet> heard;
};

double youngOf(const Document& document, const std::string& id) {
  return document.joint().materials[findMaterial(document.joint(), id)].youngsModulus;
}

TEST(Document, openingTellsThatEverythingChangedAndForgetsUndo) {
  Document document;
  EXPECT_TRUE(document.isEmpty());
  document.open(blockScene(), "a");
  document.setYoungsModulus("tissue", 1234);
  Listener listener(document);
  document.open(blockScene(), "b");
  ASSERT_EQ(listener.heard.size(), 1u);
  EXPECT_TRUE(listener.heard[0].everything);
  EXPECT_TRUE(listener.heard[0].model);
  EXPECT_FALSE(document.undoStack().canUndo());
  EXPECT_EQ(document.path(), "b");
}

TEST(Document, anEditIsDoneUndoneAndRedoneWithTheSameValues) {
  Document document;
  document.open(blockScene(), "a");
  const std::vector<Material> before = document.joint().materials;
  Listener listener(document);
  document.setYoungsModulus("tissue", 1234);
  EXPECT_EQ(youngOf(document, "tissue"), 1234);
  const std::vector<Material> after = document.joint().materials;
  document.undoStack().undo();
  EXPECT_EQ(document.joint().materials, before);
  document.undoStack().redo();
  EXPECT_EQ(document.joint().materials, after);
  ASSERT_EQ(listener.heard.size(), 3u);
  for (const ChangeSet& changes : listener.heard) {
    EXPECT_EQ(changes.materials, std::set<std::string>{"tissue"});
    EXPECT_TRUE(changes.model);
    EXPECT_FALSE(changes.everything);
  }
}

TEST(Document, oneGestureIsOneUndoStep) {
  Document document;
  document.open(blockScene(), "a");
  const double before = youngOf(document, "tissue");
  for (const double pascal : {1e3, 2e3, 3e3}) document.setYoungsModulus("tissue", pascal);
  document.endGesture();
  document.setYoungsModulus("tissue", 4e3);
  EXPECT_EQ(document.undoStack().count(), 2);
  document.undoStack().undo();
  EXPECT_EQ(youngOf(document, "tissue"), 3e3);
  document.undoStack().undo();
  EXPECT_EQ(youngOf(document, "tissue"), before);
}

TEST(Document, anEditOfNothingIsNoStep) {
  Document document;
  document.open(blockScene(), "a");
  document.setYoungsModulus("no such material", 1);
  document.setCouplingStiffness("no such coupling", 1);
  document.setYoungsModulus("tissue", youngOf(document, "tissue"));
  document.setProfile(document.scenario().profile);
  EXPECT_EQ(document.undoStack().count(), 0);
}

TEST(Document, couplingAndProfileCanBeEdited) {
  Document document;
  document.open({scenes::figure4Joint(), scenes::figure4Scenario(), nullptr}, "a");
  document.setCouplingStiffness("c12", 5e7);
  EXPECT_EQ(document.joint().couplings[0].stiffnessPerArea, 5e7);
  document.setProfile(Profile::Paper);
  EXPECT_EQ(document.scenario().profile, Profile::Paper);
  document.undoStack().undo();
  document.undoStack().undo();
  EXPECT_EQ(document.joint().couplings[0].stiffnessPerArea, 1e8);
  EXPECT_EQ(document.scenario().profile, Profile::Direct);
}

TEST(Document, savingMakesItClean) {
  Document document;
  document.open(blockScene(), "a");
  document.setProfile(Profile::Reference);
  EXPECT_FALSE(document.undoStack().isClean());
  document.saved("c");
  EXPECT_TRUE(document.undoStack().isClean());
  document.undoStack().undo();
  EXPECT_FALSE(document.undoStack().isClean());
}

}  // namespace
}  // namespace glenoid
