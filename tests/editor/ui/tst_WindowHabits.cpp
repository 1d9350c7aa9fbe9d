// SPDX-License-Identifier: GPL-3.0-or-later
// What every desktop program does: Save saves, Space presses the button that has the focus, Tab goes to what can be seen, and
// a scene that was just opened is as it was, with its own settings.
#include <QCheckBox>
#include <QFile>
#include <QPushButton>
#include <QTemporaryDir>

#include "app/StudioScene.h"
#include "editor/core/PartEdits.h"
#include "simcore/scene/RecordingFile.h"
#include "simcore/scene/ScenarioFile.h"
#include "tests/editor/ui/GuiTest.h"

namespace glenoid {
namespace {

class WindowHabits : public GuiTest {
 protected:
  Result<Scene> load(const std::string& path) override {
    if (path.find('/') != std::string::npos) return loadScene(path);
    Scene scene = blockScene();
    Recording input;
    input.tracks = {{"finger", {{0, scene.scenario.tools[0].home}}}};
    scene.input = std::make_shared<const Recording>(input);
    return scene;
  }
  Result<Done> save(const Scene& scene, const std::string& path) override { return saveScene(scene, path); }
};

TEST_F(WindowHabits, saveSavesWhereTheSceneLiesWithoutAQuestionAndKeepsItsJoint) {
  QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("mine.scenario.json"));
  Scene scene = document.scene();
  scene.scenario.joint = "bones.joint";
  scene.scenario.input = "hands.recording";
  Recording hands;
  hands.scenario = "mine";
  hands.profile = "direct";
  ASSERT_TRUE(saveRecording(hands, folder.filePath(QStringLiteral("hands.recording")).toStdString()));
  ASSERT_TRUE(saveScene(scene, path.toStdString()));  // writes mine.joint; a file that names its joint otherwise:
  ASSERT_TRUE(QFile::rename(folder.filePath(QStringLiteral("mine.joint")), folder.filePath(QStringLiteral("bones.joint"))));
  ASSERT_TRUE(saveScenario(scene.scenario, path.toStdString()));
  window->openScene(path);
  ASSERT_TRUE(until([&] { return document.path() == path; }));
  ASSERT_TRUE(renamePart(document, "block", QStringLiteral("Deltoid")));
  EXPECT_FALSE(document.undoStack().isClean());
  QTest::keyClick(window.get(), Qt::Key_S, Qt::ControlModifier);
  EXPECT_TRUE(document.undoStack().isClean());
  EXPECT_FALSE(QFile::exists(folder.filePath(QStringLiteral("mine.joint")))) << "no second joint";
  const auto again = loadScene(path.toStdString());
  ASSERT_TRUE(again) << toLogLine(again.error());
  EXPECT_EQ(again->joint.parts.at(1).name, "Deltoid");
  EXPECT_EQ(again->scenario.joint, "bones.joint");
  EXPECT_EQ(again->scenario.input, "hands.recording") << "saved where it lies it keeps its hands";
}

TEST_F(WindowHabits, spacePressesTheButtonThatHasTheFocusAndPlaysElsewhere) {
  QPushButton* button = child<QPushButton>("showAll");
  ASSERT_TRUE(button->isVisible());
  int pressed = 0;
  QObject::connect(button, &QPushButton::clicked, window.get(), [&] { ++pressed; });
  button->setFocus();
  QTest::keyClick(button, Qt::Key_Space);
  EXPECT_EQ(pressed, 1);
  settle();
  EXPECT_FALSE(snapshot().playing);
  auto* follow = child<QCheckBox>("followRecording");
  follow->setFocus();
  QTest::keyClick(follow, Qt::Key_Space);
  EXPECT_FALSE(follow->isChecked());
  window->view()->setFocus();
  QTest::keyClick(window->view(), Qt::Key_Space);
  EXPECT_TRUE(until([this] { return snapshot().playing; }));
  link.pause();
}

TEST_F(WindowHabits, tabStopsWhereItCanBeSeenAndChangesNothing) {
  window->view()->setFocus();
  for (int i = 0; i < 60; ++i) {
    QTest::keyClick(QApplication::focusWidget() ? QApplication::focusWidget() : window.get(), Qt::Key_Tab);
    QWidget* now = QApplication::focusWidget();
    ASSERT_TRUE(now);
    EXPECT_FALSE(now->visibleRegion().isEmpty()) << now->objectName().toStdString() << " " << now->metaObject()->className();
  }
  EXPECT_TRUE(document.undoStack().isClean());
}

TEST_F(WindowHabits, anotherSceneIsFollowedAgain) {
  auto* follow = child<QCheckBox>("followRecording");
  QTest::mouseClick(follow, Qt::LeftButton, {}, QPoint(8, follow->height() / 2));
  ASSERT_FALSE(link.followsRecording());
  window->openScene(QStringLiteral("another"));
  EXPECT_TRUE(until([&] { return link.followsRecording(); }));
  EXPECT_TRUE(follow->isChecked());
}

TEST_F(WindowHabits, whatIsOpenedAfterARecoveryIsClean) {
  document.openUnsaved(blockScene(), QStringLiteral("recovered"));
  EXPECT_FALSE(document.undoStack().isClean());
  document.open(blockScene(), QStringLiteral("clean"));
  EXPECT_TRUE(document.undoStack().isClean());
}

}  // namespace
}  // namespace glenoid
