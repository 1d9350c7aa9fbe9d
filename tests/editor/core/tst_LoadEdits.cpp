// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/LoadEdits.h"

#include <gtest/gtest.h>

#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

Scene loaded() {
  Scene scene{scenes::figure4Joint(), scenes::figure4Scenario(), nullptr};  // "left" is fixed, "middle" soft, "right" rigid
  scene.scenario.loads = {{"right", Vec3(1, 2, 3), Vec3::Zero(), Vec3(0.01, 0, 0)}, {"middle", Vec3(0, 4, 0)}};
  scene.scenario.loadRise = 0.5;
  return scene;
}

class LoadEditsTest : public testing::Test {
 protected:
  LoadEditsTest() {
    document.open(loaded(), {});
    fixed = document.scenario().fixedParts.at(0);
  }
  const std::vector<Load>& loads() const { return document.scenario().loads; }
  /// Undo brings back what was, redo what came of it.
  void expectUndo() {
    const Scenario after = document.scenario();
    document.undoStack().undo();
    EXPECT_EQ(loads(), loaded().scenario.loads);
    EXPECT_EQ(document.scenario().loadRise, 0.5);
    document.undoStack().redo();
    EXPECT_EQ(loads(), after.loads);
    EXPECT_EQ(document.scenario().loadRise, after.loadRise);
    document.undoStack().undo();
  }
  Document document;
  std::string fixed;
};

TEST_F(LoadEditsTest, eachIsOneStepAndComesBack) {
  Load load = loads()[0];
  load.force_W.x() = -7;
  load.torque_W.z() = 0.25;
  load.point_W.reset();
  EXPECT_TRUE(setLoad(document, 0, load));
  EXPECT_EQ(loads()[0], load);
  EXPECT_EQ(document.undoStack().count(), 1);
  expectUndo();
  EXPECT_TRUE(setLoadRise(document, 2));
  EXPECT_EQ(document.scenario().loadRise, 2);
  expectUndo();
  EXPECT_TRUE(addLoad(document, "middle"));
  ASSERT_EQ(loads().size(), 3u);
  EXPECT_EQ(loads()[2].part, "middle");
  EXPECT_EQ(loads()[2].force_W, Vec3(0, -1, 0));
  expectUndo();
  EXPECT_TRUE(removeLoad(document, 0));
  ASSERT_EQ(loads().size(), 1u);
  EXPECT_EQ(loads()[0].part, "middle");
  expectUndo();
}

TEST_F(LoadEditsTest, aDragIsOneStepAndTheRunIsToldOfEach) {
  int models = 0;
  QObject::connect(&document, &Document::changed, [&](const ChangeSet& changes) { models += changes.model && changes.parts.count("right"); });
  Load load = loads()[0];
  for (int i = 0; i < 5; ++i) {
    load.force_W.y() += 1;
    EXPECT_TRUE(setLoad(document, 0, load));
  }
  EXPECT_EQ(models, 5);
  EXPECT_EQ(document.undoStack().count(), 1);
  document.endGesture();
  load.force_W.y() += 1;
  EXPECT_TRUE(setLoad(document, 0, load));
  EXPECT_EQ(document.undoStack().count(), 2);
}

TEST_F(LoadEditsTest, whatTheSchemaOrTheJointRefusesIsRefused) {
  const auto refused = [&](int index, auto&& how) {
    Load load = loads()[std::max(0, std::min<int>(index, 1))];
    how(load);
    return !setLoad(document, index, load);
  };
  EXPECT_TRUE(refused(0, [](Load&) {})) << "the same";
  EXPECT_TRUE(refused(2, [](Load& l) { l.force_W.x() = 9; }));
  EXPECT_TRUE(refused(-1, [](Load& l) { l.force_W.x() = 9; }));
  EXPECT_TRUE(refused(0, [](Load& l) { l.force_W.x() = 1.1e6; })) << "beyond the schema";
  EXPECT_TRUE(refused(0, [](Load& l) { l.force_W.x() = NAN; }));
  EXPECT_TRUE(refused(0, [](Load& l) { l.point_W = Vec3(0, HUGE_VAL, 0); }));
  EXPECT_TRUE(refused(0, [&](Load& l) { l.part = fixed; }));
  EXPECT_TRUE(refused(0, [](Load& l) { l.part = "spleen"; }));
  EXPECT_TRUE(refused(1, [](Load& l) { l.torque_W.x() = 1; })) << "a torque on tissue";
  EXPECT_FALSE(setLoadRise(document, -0.1));
  EXPECT_FALSE(setLoadRise(document, 1.1e6));
  EXPECT_FALSE(setLoadRise(document, NAN));
  EXPECT_FALSE(setLoadRise(document, 0.5)) << "the same";
  EXPECT_FALSE(addLoad(document, fixed));
  EXPECT_FALSE(addLoad(document, "spleen"));
  EXPECT_FALSE(removeLoad(document, 2));
  EXPECT_EQ(document.undoStack().count(), 0);
  EXPECT_FALSE(refused(0, [](Load& l) { l.force_W.x() = 1e6; })) << "its edge is let pass";
}

}  // namespace
}  // namespace glenoid
