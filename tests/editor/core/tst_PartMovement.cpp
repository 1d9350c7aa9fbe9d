// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/PartMovement.h"

#include <gtest/gtest.h>

namespace glenoid {
namespace {

Scene twoParts() {
  Scene scene;
  for (const char* id : {"bone", "muscle"}) {
    Part part;
    part.id = part.name = id;
    part.number = static_cast<int>(scene.joint.parts.size()) + 1;
    part.kind = scene.joint.parts.empty() ? PartKind::Rigid : PartKind::Soft;
    scene.joint.parts.push_back(part);
  }
  scene.scenario.loads = {{"bone", Vec3(0, 1, 0), Vec3::Zero()}};
  return scene;
}

TEST(PartMovement, eachChangeIsOneStepAndComesBack) {
  Document document;
  document.open(twoParts(), {});
  EXPECT_EQ(movementOf(document.scenario(), "bone"), Movement::Free);
  EXPECT_TRUE(setMovement(document, "bone", Movement::Held));
  EXPECT_EQ(movementOf(document.scenario(), "bone"), Movement::Held);
  EXPECT_EQ(document.scenario().holds, (std::vector<Hold>{Hold{"bone"}}));
  EXPECT_EQ(document.scenario().loads.size(), 1u);
  EXPECT_TRUE(setMovement(document, "bone", Movement::Fixed));
  EXPECT_TRUE(document.scenario().holds.empty());
  EXPECT_TRUE(document.scenario().loads.empty());  // nothing moves what is fixed
  EXPECT_FALSE(setMovement(document, "bone", Movement::Fixed));
  EXPECT_EQ(document.undoStack().count(), 2);
  document.undoStack().undo();
  EXPECT_EQ(movementOf(document.scenario(), "bone"), Movement::Held);
  EXPECT_EQ(document.scenario().loads.size(), 1u);
  document.undoStack().undo();
  EXPECT_EQ(movementOf(document.scenario(), "bone"), Movement::Free);
}

/// What holds a part still takes its loads, not what is to be done on it.
TEST(PartMovement, aFixedPartKeepsItsTasks) {
  Document document;
  Scene scene = twoParts();
  Task task;
  task.id = "touch";
  task.places = {{"bone", "", "", Vec3(0.01, 0, 0), {}}};
  scene.scenario.training.tasks = {task};
  scene.scenario.training.limits = {{"gentle", "", "bone", "", 2}};
  document.open(scene, {});
  EXPECT_TRUE(setMovement(document, "bone", Movement::Fixed));
  EXPECT_TRUE(document.scenario().training == scene.scenario.training);
}

TEST(PartMovement, tissueIsFixedOrFreeAndStrangersAreRefused) {
  Document document;
  document.open(twoParts(), {});
  EXPECT_FALSE(setMovement(document, "muscle", Movement::Held));
  EXPECT_TRUE(setMovement(document, "muscle", Movement::Fixed));
  EXPECT_TRUE(setMovement(document, "muscle", Movement::Free));
  EXPECT_FALSE(setMovement(document, "ulna", Movement::Fixed));
}

TEST(PartMovement, tissueMayTouchItself) {
  Document document;
  document.open(twoParts(), {});
  EXPECT_FALSE(foldsOntoItself(document.scenario(), "muscle"));
  EXPECT_FALSE(setFoldsOntoItself(document, "bone", true));  // bone does not bend
  EXPECT_FALSE(setFoldsOntoItself(document, "ulna", true));
  EXPECT_FALSE(setFoldsOntoItself(document, "muscle", false));
  EXPECT_TRUE(setFoldsOntoItself(document, "muscle", true));
  EXPECT_EQ(document.scenario().selfContactParts, (std::vector<std::string>{"muscle"}));
  EXPECT_TRUE(setMovement(document, "muscle", Movement::Fixed));
  EXPECT_TRUE(document.scenario().selfContactParts.empty());  // nor does what is fixed
  EXPECT_FALSE(setFoldsOntoItself(document, "muscle", true));
  document.undoStack().undo();
  EXPECT_TRUE(foldsOntoItself(document.scenario(), "muscle"));
  EXPECT_TRUE(setFoldsOntoItself(document, "muscle", false));
  EXPECT_FALSE(foldsOntoItself(document.scenario(), "muscle"));
  document.undoStack().undo();
  document.undoStack().undo();
  EXPECT_TRUE(document.scenario().selfContactParts.empty());
}

TEST(PartMovement, anEmptySceneHasNoParts) {
  Document document;
  document.open(emptyScene(QStringLiteral("Untitled")), {});
  EXPECT_TRUE(document.isEmpty());
  EXPECT_EQ(document.joint().name, "Untitled");
}

}  // namespace
}  // namespace glenoid
