// SPDX-License-Identifier: GPL-3.0-or-later
// A trainee's way through tasks in the window: what is to be done, a hint, how it went, again.
#include <QDialog>
#include <QDropEvent>
#include <QFile>
#include <QLineEdit>
#include <QListWidget>
#include <QMimeData>
#include <QPushButton>
#include <QTableWidget>
#include <QTemporaryDir>
#include <QTimer>

#include "app/StudioScene.h"
#include "app/WindowRecords.h"
#include "app/records/RecordStore.h"
#include "editor/core/TrainingSentences.h"
#include "editor/ui/training/TasksPanel.h"
#include "simcore/live/Run.h"
#include "simcore/scene/RecordingFile.h"
#include "tests/editor/ui/GuiTest.h"

namespace glenoid {
namespace {

/// The finger goes down on the block by itself after half a second.
class TasksPanelTest : public GuiTest {
 protected:
  Result<Scene> load(const std::string& path) override {
    Scene scene = blockScene();
    if (path != "tasks") return scene;
    Task touch;
    touch.id = "touch";
    touch.name = "Touch the block";
    touch.text = "Press it gently.";
    touch.hint = "It is under the finger.";
    touch.tool = "finger";
    touch.places = {{"block", "", "", {}, {}}};
    touch.hold = 0.2;
    Task wait = touch;
    wait.id = "plate";
    wait.name = "Touch the plate";
    wait.places[0].part = "plate";
    wait.timeMax = 3;
    scene.scenario.training.text = "Two things to touch.";
    scene.scenario.training.tasks = {touch, wait};
    scene.scenario.training.ordered = true;
    scene.scenario.training.form = {{"tasks", 100, 1, 0}};
    scene.scenario.training.passScore = 40;
    Recording input;
    const Pose home = scene.scenario.tools[0].home;
    Pose down = home;
    down.p_WB.y() -= 0.025;
    input.tracks = {{"finger", {{0, home}, {0.5, home}, {1.0, down}}}};
    scene.input = std::make_shared<const Recording>(input);
    return scene;
  }
  QString row(int i) { return child<QListWidget>("taskList")->item(i)->text(); }
};

TEST_F(TasksPanelTest, leadsThroughAndSaysHowItWent) {
  window->openScene(QStringLiteral("tasks"));
  auto* list = child<QListWidget>("taskList");
  ASSERT_TRUE(until([&] { return list->count() == 2 && link.snapshot().training; }));
  ASSERT_TRUE(until([&] { return list->isVisible(); })) << "a scene with tasks shows them";
  EXPECT_EQ(child<QLabel>("trainingText")->text(), QStringLiteral("Two things to touch."));
  ASSERT_TRUE(until([&] { return row(0).contains(QStringLiteral("to do")) && row(1).contains(QStringLiteral("later")); })) << row(0).toStdString();
  EXPECT_EQ(child<QLabel>("taskText")->text(), QStringLiteral("Press it gently."));
  QTest::mouseClick(child<QPushButton>("taskHint"), Qt::LeftButton);
  EXPECT_TRUE(child<QLabel>("taskText")->text().contains(QStringLiteral("under the finger")));
  EXPECT_EQ(selection.ids(), std::set<std::string>{"block"}) << "and where it is";
  EXPECT_FALSE(child<QTableWidget>("trainingFigures")->isVisible());

  link.play();
  ASSERT_TRUE(until([&] { return row(0).contains(QStringLiteral("done")); })) << row(0).toStdString();
  ASSERT_TRUE(until([&] { return row(1).contains(QStringLiteral("missed")); })) << row(1).toStdString();
  auto* figures = child<QTableWidget>("trainingFigures");
  ASSERT_TRUE(until([&] { return figures->isVisible() && figures->rowCount() > 5; }));
  EXPECT_EQ(child<QLabel>("trainingResult")->text(), QStringLiteral("1 of 2 tasks done. 50 of 100 points: passed."));
  link.pause();
  // A figure shows its formula when it is chosen.
  int path = -1;
  for (int i = 0; i < figures->rowCount(); ++i)
    if (figures->item(i, 0)->text().contains(QStringLiteral("length of the path"))) path = i;
  ASSERT_GE(path, 0);
  figures->setCurrentCell(path, 0);
  EXPECT_TRUE(child<QLabel>("metricFormula")->text().contains(QStringLiteral("Σ")));
  EXPECT_TRUE(child<QLabel>("metricFormula")->text().contains(QStringLiteral("Experimental")));

  QTest::mouseClick(child<QPushButton>("trainAgain"), Qt::LeftButton);
  EXPECT_TRUE(until([&] { return row(0).contains(QStringLiteral("to do")); }));
  EXPECT_TRUE(until([&] { return !figures->isVisible(); }));
  link.pause();
}

TEST_F(TasksPanelTest, aSceneWithoutTasksSaysSo) {
  EXPECT_FALSE(child<QListWidget>("taskList")->isVisible());
  EXPECT_TRUE(child<QLabel>("trainingText")->text().contains(QStringLiteral("no tasks")));
}

/// Who says a name finds the run again, by mouse and keys alone.
TEST_F(TasksPanelTest, aRunIsKeptForWhoSaysTheirName) {
  QTemporaryDir folder;
  const std::string place = folder.filePath(QStringLiteral("r.sqlite")).toStdString();
  WindowRecords records(document, link, window->tasks(), place);
  window->openScene(QStringLiteral("tasks"));
  ASSERT_TRUE(until([&] { return child<QListWidget>("taskList")->count() == 2 && child<QLineEdit>("trainee")->isVisible(); }));
  QTest::mouseClick(child<QLineEdit>("trainee"), Qt::LeftButton);
  link.play();  // typed while it runs: no letter of it is somebody
  ASSERT_TRUE(until([&] { return snapshot().time > 0.1; }));
  for (const QChar letter : QStringLiteral("Ana")) {
    QTest::keyClicks(child<QLineEdit>("trainee"), QString(letter));
    QTest::qWait(100);  // settle() would wait for the run to stand still
  }
  QTest::keyClick(child<QLineEdit>("trainee"), Qt::Key_Return);
  ASSERT_TRUE(until([&] { return child<QLabel>("recordSentence")->text() == QStringLiteral("Kept for Ana."); })) << child<QLabel>("recordSentence")->text().toStdString();
  link.pause();
  const auto runs = RecordStore::open(place).value()->list("Ana");
  ASSERT_TRUE(runs && runs->size() == 1);
  EXPECT_EQ(RecordStore::open(place).value()->list("")->size(), 1u) << "and nobody else's";
  EXPECT_TRUE(runs->at(0).ended);
  EXPECT_DOUBLE_EQ(runs->at(0).score.value_or(0), 50);
  int rows = 0;
  QTimer::singleShot(500, window.get(), [&] {
    if (auto* dialog = window->findChild<QDialog*>(QStringLiteral("ownRuns"))) {
      if (auto* table = dialog->findChild<QTableWidget*>(QStringLiteral("ownRunsTable"))) rows = table->rowCount();
      dialog->reject();
    }
  });
  QTest::mouseClick(child<QPushButton>("ownRunsButton"), Qt::LeftButton);
  EXPECT_EQ(rows, 1);
}

TEST_F(TasksPanelTest, recordsThatCannotBeOpenedAreSaidAndTheRunGoesOn) {
  WindowRecords records(document, link, window->tasks(), "/nonexistent/r.sqlite");
  window->openScene(QStringLiteral("tasks"));
  ASSERT_TRUE(until([&] { return child<QListWidget>("taskList")->count() == 2 && child<QLineEdit>("trainee")->isVisible(); }));
  child<QLineEdit>("trainee")->setText(QStringLiteral("Ana"));
  emit child<QLineEdit>("trainee")->editingFinished();
  link.play();
  EXPECT_TRUE(until([&] { return child<QLabel>("recordSentence")->text().contains(QStringLiteral("cannot be opened")); }));
  EXPECT_TRUE(until([&] { return row(0).contains(QStringLiteral("done")); }));
  link.pause();
}

/// What a hand did in the window, dragged tool included, gives the same state and the same score without it.
TEST_F(TasksPanelTest, aSavedRunReplaysToTheSameHashAndScore) {
  QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("run.recording"));
  window->saveRunTo(path);
  EXPECT_TRUE(until([&] { return child<QLabel>("problem")->isVisible(); })) << "nothing was run";
  window->openScene(QStringLiteral("tasks"));
  ASSERT_TRUE(until([&] { return child<QListWidget>("taskList")->count() == 2 && link.snapshot().training; }));
  link.play();
  ASSERT_TRUE(until([&] { return snapshot().time > 0.8; }));
  Pose aside = link.handOf(0);  // somebody takes the tool, turns it and lets go
  aside.p_WB += Vec3(0.01, -0.004, 0.006);
  aside.q_WB = Quat(Eigen::AngleAxisd(0.3, Vec3(0.3, 0.5, 0.8).normalized())) * aside.q_WB;
  link.holdTool(0, aside);
  ASSERT_TRUE(until([&] { return snapshot().time > 1.6; }));
  link.releaseTool(0);
  ASSERT_TRUE(until([&] { return snapshot().training && snapshot().training->finished; }));
  link.pause();
  ASSERT_TRUE(until([&] { return !snapshot().playing; }));
  window->saveRunTo(path);
  ASSERT_TRUE(until([&] { return QFile::exists(path); }));
  const auto recording = loadRecording(path.toStdString());
  ASSERT_TRUE(recording) << toLogLine(recording.error());
  EXPECT_EQ(recording->steps, snapshot().step);
  RunOptions options;
  options.steps = recording->steps;
  options.input = &*recording;
  options.checks = false;
  const auto again = runScenario(snapshot().model, options);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->report.stateHash, recording->stateHash);
  EXPECT_TRUE(tasksJson(*again->report.training) == tasksJson(*snapshot().training));
}

/// A saved run, dropped on the window, is watched again: its scene with its hands, under the scene's own name.
class RecordedRuns : public GuiTest {
 protected:
  Result<Scene> load(const std::string& path) override { return path.find('/') != std::string::npos ? loadScene(path) : blockScene(); }
};

TEST_F(RecordedRuns, droppedOnTheWindowAreWatchedAgain) {
  QTemporaryDir folder;
  const std::string path = folder.filePath(QStringLiteral("mine.recording")).toStdString();
  Recording recording;
  recording.scenario = "builtin:landmarks";
  recording.dt = 0.004;
  recording.profile = "direct";
  const Pose home{Vec3(0.1, 0.2, 0.3), Quat::Identity()};
  recording.tracks = {{"finger", {{0, home}, {1, home}}}};
  ASSERT_TRUE(saveRecording(recording, path));
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(QString::fromStdString(path))});
  QDragEnterEvent enter(QPoint(300, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(window.get(), &enter);
  ASSERT_TRUE(enter.isAccepted());
  QDropEvent event(QPointF(300, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  QCoreApplication::sendEvent(window.get(), &event);
  ASSERT_TRUE(until([this] { return document.scenario().id == "landmarks"; }, 60000)) << child<QLabel>("problem")->text().toStdString();
  EXPECT_EQ(document.path(), QStringLiteral("builtin:landmarks")) << "what is run now is of the scene's file";
  EXPECT_DOUBLE_EQ(document.scenario().dt, 0.004);
  ASSERT_TRUE(document.scene().input);
  EXPECT_EQ(document.scene().input->tracks.at(0).keys.at(1).hand.p_WB, home.p_WB);
  EXPECT_TRUE(until([this] { return snapshot().training != nullptr; }, 60000));
}

TEST_F(RecordedRuns, ofAToolThatIsNotThereAreRefusedByName) {
  QTemporaryDir folder;
  const std::string path = folder.filePath(QStringLiteral("other.recording")).toStdString();
  Recording recording;
  recording.scenario = "builtin:landmarks";
  recording.profile = "direct";
  recording.tracks = {{"spoon", {{0, Pose{}}}}};
  ASSERT_TRUE(saveRecording(recording, path));
  window->openScene(QString::fromStdString(path));
  EXPECT_TRUE(until([this] { return child<QLabel>("problem")->text().contains(QStringLiteral("spoon")); }, 60000));
}

TEST_F(TasksPanelTest, theStateIsSaidInEveryLanguage) {
  window->openScene(QStringLiteral("tasks"));
  ASSERT_TRUE(until([&] { return child<QListWidget>("taskList")->count() == 2 && link.snapshot().training; }));
  ASSERT_TRUE(until([&] { return row(0).contains(QStringLiteral("to do")); }));
  setLanguage(QStringLiteral("es"));
  EXPECT_TRUE(until([&] { return !row(0).contains(QStringLiteral("to do")); })) << row(0).toStdString();
}

}  // namespace
}  // namespace glenoid
