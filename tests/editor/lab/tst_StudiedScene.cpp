// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/lab/StudiedScene.h"

#include <gtest/gtest.h>

#include <QTemporaryDir>

#include "editor/core/SameScene.h"
#include "simcore/scene/JointFile.h"
#include "simcore/scene/RecordingFile.h"
#include "simcore/scene/ScenarioFile.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

/// Of enough bricks that twice and four times as many can be cut.
Scene blockOnPlate() {
  Scene scene{scenes::blockOnPlateJoint(), scenes::blockOnPlateScenario(), nullptr};
  scene.joint.parts[1] = scenes::boxPart("block", 2, PartKind::Soft, Vec3(-0.02, 0.0005, -0.02), Vec3(0.02, 0.0405, 0.02), 5);
  return scene;
}

std::size_t tetrahedraIn(const Joint& joint) {
  std::size_t count = 0;
  for (const Part& part : joint.parts) count += part.volume ? part.volume->tets.size() : 0;
  return count;
}

class StudiedSceneTest : public testing::Test {
 protected:
  void SetUp() override {
    document.open(blockOnPlate(), QStringLiteral("block.scenario.json"));
    studied = StudiedScene::make(document.scene()).value();
  }
  SettingApplied apply(const std::string& id) {
    const Result<Scene> wanted = studied->with(id);
    if (!wanted) {
      ADD_FAILURE() << toLogLine(wanted.error());
      return {};
    }
    const Scene made = *wanted;
    const SettingApplied applied = applySetting(document, studied->scene(), made, last, QString::fromStdString(id));
    if (!applied.refused) last = document.joint();
    return applied;
  }
  Document document;
  std::shared_ptr<const StudiedScene> studied;
  std::optional<Joint> last;
};

TEST_F(StudiedSceneTest, aSettingIsOneUndoStepThatKeepsOtherEdits) {
  document.edit(QStringLiteral("gravity"), {}, [](Scene& scene) { scene.scenario.gravity_W = Vec3(0, -1, 0); });
  const SettingApplied applied = apply("dt=2.5ms");
  EXPECT_EQ(applied.sentence.toStdString(), "Steps of 2.5 ms in place of 5 ms.");
  EXPECT_DOUBLE_EQ(document.scenario().dt, 0.0025);
  EXPECT_EQ(document.scenario().gravity_W, Vec3(0, -1, 0));
  EXPECT_EQ(document.undoStack().count(), 2);
  document.undoStack().undo();
  EXPECT_DOUBLE_EQ(document.scenario().dt, 0.005);
  EXPECT_EQ(document.scenario().gravity_W, Vec3(0, -1, 0));
  document.undoStack().redo();
  EXPECT_TRUE(apply("dt=2.5ms").sentence.isEmpty()) << "it has that already";
  EXPECT_EQ(document.undoStack().count(), 2);
}

TEST_F(StudiedSceneTest, settingsAreOfTheStudiedSceneAndNotOfTheLastOne) {
  const std::size_t before = tetrahedraIn(document.joint());
  EXPECT_FALSE(apply("cells=2").refused);
  const std::size_t twice = tetrahedraIn(document.joint());
  EXPECT_GT(twice, before);
  EXPECT_FALSE(apply("cells=4").refused);
  EXPECT_EQ(tetrahedraIn(document.joint()), tetrahedraIn(studied->with("cells=4")->joint)) << "not of the finer ones";
  apply("scene");
  EXPECT_TRUE(sameJoint(document.joint(), studied->scene().joint));
  for (int k = 0; k < 3; ++k) document.undoStack().undo();
  EXPECT_TRUE(sameJoint(document.joint(), studied->scene().joint));
}

TEST_F(StudiedSceneTest, otherCellsAreRefusedOnAJointThatWasEdited) {
  document.setYoungsModulus("tissue", 12345);
  const int count = document.undoStack().count();
  const SettingApplied refused = apply("cells=2");
  EXPECT_TRUE(refused.refused);
  EXPECT_TRUE(refused.sentence.contains(QStringLiteral("edited since"))) << refused.sentence.toStdString();
  EXPECT_EQ(document.undoStack().count(), count);
  EXPECT_FALSE(apply("dt=2.5ms").refused) << "what leaves the joint alone goes";
  EXPECT_DOUBLE_EQ(document.joint().materials[static_cast<std::size_t>(findMaterial(document.joint(), "tissue"))].youngsModulus, 12345);
}

TEST_F(StudiedSceneTest, whatNoScenarioCanSayIsRefused) {
  EXPECT_FALSE(studied->with("profile=paper,paper=all"));
  EXPECT_FALSE(studied->with("no=such"));
}

TEST_F(StudiedSceneTest, aCopyIsTheSameSceneWithItsInput) {
  QTemporaryDir folder;
  auto input = std::make_shared<Recording>();
  input->profile = "direct";
  input->tracks = {{"finger", {{0, Pose{}}, {1, Pose{Vec3(0, 0.1, 0), Quat::Identity()}}}}};
  Scene scene = blockOnPlate();
  scene.input = input;
  scene.scenario.input = "gone.recording";
  const Result<std::string> saved = saveStudied(scene, folder.path().toStdString(), "studied");
  ASSERT_TRUE(saved) << toLogLine(saved.error());
  const Scenario scenario = loadScenario(*saved).value();
  EXPECT_EQ(scenario.joint, "studied.joint");
  EXPECT_EQ(scenario.input, "studied.recording");
  EXPECT_EQ(loadRecording(folder.path().toStdString() + "/studied.recording").value().tracks.size(), 1u);
  EXPECT_EQ(jointHash(loadJoint(folder.path().toStdString() + "/studied.joint").value()), jointHash(scene.joint));
}

}  // namespace
}  // namespace glenoid
