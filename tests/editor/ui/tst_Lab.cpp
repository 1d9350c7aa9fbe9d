// SPDX-License-Identifier: GPL-3.0-or-later
// The lab in a real window, with real studies in processes of their own.
#include <QComboBox>
#include <QDir>
#include <QDockWidget>
#include <QFile>
#include <QLabel>
#include <QLineEdit>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalSpy>
#include <QTableWidget>
#include <QTemporaryDir>

#include "app/StudioScene.h"
#include "editor/ui/Workspaces.h"
#include "editor/ui/lab/AccuracyPanel.h"
#include "editor/ui/lab/AccuracyPlot.h"
#include "editor/ui/lab/EffectsPanel.h"
#include "editor/ui/lab/LabDocks.h"
#include "editor/ui/lab/PictureLabel.h"
#include "editor/ui/lab/StabilityPanel.h"
#include "editor/ui/lab/StudyBar.h"
#include "tests/editor/ui/GuiTest.h"

namespace glenoid {
namespace {

class Lab : public GuiTest {
 protected:
  void SetUp() override {
    GuiTest::SetUp();
    window->resize(1560, 960);
    window->workspaces().show(QStringLiteral("lab"));
  }
  Result<Scene> load(const std::string& path) override { return path == "block" ? Result<Scene>(blockScene()) : loadScene(path); }
  LabServices labServices() override { return glenoid::labServices(QStringLiteral(GLENOID_PROGRAM)); }

  AccuracyPanel& accuracy() { return window->lab().accuracy(); }
  StabilityPanel& stability() { return window->lab().stability(); }
  QString path(const char* leaf) const { return folder.filePath(QLatin1String(leaf)); }
  void raise(const char* dock) {
    auto* found = child<QDockWidget>(dock);
    found->show();
    found->raise();
    QTest::qWait(50);
  }
  /// Looked at by people: GLENOID_SHOTS names the folder.
  void shoot(const char* name) {
    const QString shots = qEnvironmentVariable("GLENOID_SHOTS");
    if (shots.isEmpty()) return;
    QTest::qWait(300);
    window->grab().save(QDir(shots).filePath(QLatin1String(name) + QStringLiteral(".png")));
  }
  bool study(StudyBar& bar, const QString& where, int milliseconds = 240000) {
    bool ended = false;
    QString said;
    const auto heard = QObject::connect(&bar.process(), &StudyProcess::ended, window.get(), [&](StudyProcess::End, const QString& sentence) { ended = true, said = sentence; });
    bar.begin(where);
    const bool good = until([&] { return ended; }, milliseconds);
    QObject::disconnect(heard);
    EXPECT_TRUE(good && bar.study().isWhole()) << said.toStdString();
    return good && bar.study().isWhole();
  }

  QTemporaryDir folder;
};

TEST_F(Lab, workspacesShowTheirDocksAndComeBackAsTheyWereLeft) {
  EXPECT_TRUE(child<QDockWidget>("dock.lab.accuracy")->isVisible());
  EXPECT_FALSE(child<QDockWidget>("dock.properties")->isVisible());
  EXPECT_TRUE(until([this] { return child<QDockWidget>("dock.lab.accuracy")->width() >= 520; })) << child<QDockWidget>("dock.lab.accuracy")->width();
  action("workspace.author")->trigger();
  EXPECT_TRUE(until([this] { return child<QDockWidget>("dock.properties")->isVisible(); }));
  EXPECT_TRUE(child<QDockWidget>("dock.lab.accuracy")->isHidden());
  child<QDockWidget>("dock.layers")->hide();
  action("workspace.lab")->trigger();
  EXPECT_TRUE(child<QDockWidget>("dock.parts")->isHidden());
  action("workspace.author")->trigger();
  EXPECT_TRUE(child<QDockWidget>("dock.layers")->isHidden()) << "as it was left";
  EXPECT_FALSE(child<QDockWidget>("dock.parts")->isHidden());
  EXPECT_EQ(window->workspaces().current(), QStringLiteral("author"));
}

TEST_F(Lab, aQuickStudyGrowsIsAppliedAndUndone) {
  StudyBar& bar = accuracy().bar();
  AccuracyPlot& plot = accuracy().plot();
  bool grew = false;
  QObject::connect(&bar, &StudyBar::newsCame, window.get(), [&] {
    if (bar.process().isRunning() && !plot.points().points.empty() && !std::exchange(grew, true)) shoot("accuracy-grows");
  });
  ASSERT_TRUE(study(bar, path("accuracy")));
  EXPECT_TRUE(grew) << "points are there before the end";
  EXPECT_FALSE(bar.process().isRunning());
  EXPECT_TRUE(QFile::exists(path("accuracy/studied.scenario.json")) || QFile::exists(path("accuracy/accuracy.json")));
  ASSERT_GT(plot.points().points.size(), 5u);
  EXPECT_GT(plot.points().front.size(), 0u);
  for (const AccuracyPoint& point : plot.points().points) EXPECT_FALSE(point.rough) << point.id;
  shoot("accuracy");

  // A click on the point of half the step.
  const auto& points = plot.points().points;
  const auto half = std::find_if(points.begin(), points.end(), [](const AccuracyPoint& point) { return point.id == "dt=2.5ms"; });
  ASSERT_NE(half, points.end());
  const auto place = plot.placeOf(static_cast<std::size_t>(half - points.begin()));
  ASSERT_TRUE(place);
  QTest::mouseMove(&plot, place->toPoint());
  QTest::mouseClick(&plot, Qt::LeftButton, {}, place->toPoint());
  auto* words = child<QLabel>("lab.accuracy.words2");
  EXPECT_FALSE(plot.chosen().empty()) << "a click chooses";
  if (plot.chosen() != "dt=2.5ms") accuracy().choose(QStringLiteral("dt=2.5ms"));  // another point lies on it
  EXPECT_TRUE(words->text().contains(QStringLiteral("Steps of 2.5 ms"))) << words->text().toStdString();
  const double before = document.scenario().dt;
  QTest::mouseClick(child<QPushButton>("lab.accuracy.apply"), Qt::LeftButton);
  ASSERT_TRUE(until([this] { return document.scenario().dt == 0.0025; }));
  EXPECT_TRUE(child<QLabel>("lab.accuracy.sentence")->text().contains(QStringLiteral("Steps of 2.5 ms in place of 5 ms"))) << child<QLabel>("lab.accuracy.sentence")->text().toStdString();
  ASSERT_TRUE(until([this] { return snapshot().model && snapshot().model->scenario.dt == 0.0025; })) << "the run has it too";

  QTest::mouseClick(child<QPushButton>("lab.accuracy.compare"), Qt::LeftButton);
  auto* after = child<PictureLabel>("lab.accuracy.after");
  ASSERT_TRUE(until([&] { return !after->isEmpty(); }, 60000)) << child<QLabel>("lab.accuracy.sentence")->text().toStdString();
  EXPECT_FALSE(child<PictureLabel>("lab.accuracy.before")->isEmpty());
  shoot("accuracy-applied");

  action("undo")->trigger();
  EXPECT_DOUBLE_EQ(document.scenario().dt, before);
  EXPECT_TRUE(document.undoStack().isClean());

  // The pick of the window is the pick of the command line.
  QTest::mouseClick(child<QPushButton>("lab.accuracy.pick"), Qt::LeftButton);
  const auto picked = plot.points().pickForBudget(5);
  if (picked) EXPECT_EQ(plot.chosen(), plot.points().points[*picked].id);

  // Keys go through the points.
  plot.setFocus();
  QTest::keyClick(&plot, Qt::Key_Left);
  QTest::keyClick(&plot, Qt::Key_Return);
  const std::string left = plot.chosen();
  EXPECT_FALSE(left.empty());
  QTest::keyClick(&plot, Qt::Key_Right);
  QTest::keyClick(&plot, Qt::Key_Right);
  QTest::keyClick(&plot, Qt::Key_Return);
  EXPECT_NE(plot.chosen(), left);

  setLanguage(QStringLiteral("es"));
  EXPECT_TRUE(until([&] { return child<QPushButton>("lab.accuracy.apply")->text() != QStringLiteral("&Apply to the scene"); }));
  shoot("accuracy-es");
}

TEST_F(Lab, aStudyThatIsStoppedKeepsWhatItFound) {
  StudyBar& bar = accuracy().bar();
  bar.begin(path("stopped"));
  ASSERT_TRUE(until([&] { return bar.study().fraction() > 0; }, 60000));
  EXPECT_TRUE(child<QProgressBar>("lab.accuracy.progress")->isVisible());
  EXPECT_FALSE(child<QPushButton>("lab.accuracy.run")->isEnabled());
  QTest::mouseClick(child<QPushButton>("lab.accuracy.stop"), Qt::LeftButton);
  ASSERT_TRUE(until([&] { return !bar.process().isRunning(); }, 5000));
  EXPECT_TRUE(until([&] { return child<QPushButton>("lab.accuracy.run")->isEnabled(); }));
  EXPECT_TRUE(child<QLabel>("lab.accuracy.sentence")->text().startsWith(QStringLiteral("Stopped")));
  bar.openFolder(path("stopped"));
  EXPECT_EQ(bar.study().kind(), "accuracy");
  EXPECT_TRUE(child<QLabel>("lab.accuracy.sentence")->text().contains(QStringLiteral("stopped before its end")));
  bar.openFolder(folder.path());
  EXPECT_TRUE(child<QLabel>("lab.accuracy.sentence")->text().contains(QStringLiteral("no study in")));
}

TEST_F(Lab, aStudyEndsWithItsWindow) {
  StudyBar& bar = accuracy().bar();
  bar.begin(path("closed"));
  ASSERT_TRUE(until([&] { return bar.study().fraction() > 0; }, 60000));
  window->close();
  EXPECT_TRUE(until([&] { return !bar.process().isRunning(); }, 5000));
}

TEST_F(Lab, whatAStudyCannotReadIsSaid) {
  document.edit(QStringLiteral("gone"), {}, [](Scene& scene) { scene.scenario.fixedParts = {"nobody"}; });
  StudyBar& bar = accuracy().bar();
  bar.begin(path("bad"));
  auto* sentence = child<QLabel>("lab.accuracy.sentence");
  ASSERT_TRUE(until([&] { return !bar.process().isRunning() && !sentence->text().isEmpty(); }, 60000));
  EXPECT_TRUE(sentence->text().contains(QStringLiteral("nobody"))) << sentence->text().toStdString();
  EXPECT_TRUE(child<QPushButton>("lab.accuracy.run")->isEnabled());
}

TEST_F(Lab, aFailureIsRunAgainInTheViewBitForBit) {
  document.setProfile(Profile::Paper);
  raise("dock.lab.stability");
  stability().setCases({QStringLiteral("left-alone"), QStringLiteral("impact"), QStringLiteral("thousand-times-stiffer")});
  ASSERT_TRUE(study(stability().bar(), path("stability")));
  const std::vector<StabilityEntry>& entries = stability().entries();
  ASSERT_FALSE(entries.empty());
  auto* table = child<QTableWidget>("lab.stability.table");
  EXPECT_EQ(table->rowCount(), static_cast<int>(entries.size()));
  int row = -1;
  for (int r = 0; r < table->rowCount(); ++r)
    if (!entries[static_cast<std::size_t>(table->item(r, 0)->data(Qt::UserRole).toInt())].recording.empty()) row = r;
  ASSERT_GE(row, 0) << "the published method does not hold all of it";
  const StabilityEntry failure = entries[static_cast<std::size_t>(table->item(row, 0)->data(Qt::UserRole).toInt())];
  EXPECT_FALSE(failure.held);
  table->setCurrentCell(row, 0);
  shoot("stability");
  child<QLineEdit>("lab.stability.filter")->setText(QStringLiteral("no such trial"));
  EXPECT_TRUE(table->isRowHidden(row));
  child<QLineEdit>("lab.stability.filter")->setText(QString::fromStdString(failure.subject));
  EXPECT_FALSE(table->isRowHidden(row));

  const QImage before = grabView();
  table->setCurrentCell(row, 0);
  const QRect cell = table->visualItemRect(table->item(row, 0));
  QTest::mouseClick(table->viewport(), Qt::LeftButton, {}, cell.center());
  QTest::mouseDClick(table->viewport(), Qt::LeftButton, {}, cell.center());
  ASSERT_TRUE(until([this] { return link.hasGuest() && stability().replay().isShown(); }, 60000));
  ASSERT_TRUE(until([this] { return stability().replay().hasEnded(); }, 120000)) << snapshot().step << " of " << stability().replay().steps();
  ASSERT_TRUE(until([this] { return !snapshot().playing; }));
  EXPECT_EQ(stability().replay().sameAsStudied(), std::optional(true));
  settle();
  shoot("stability-replayed");
  EXPECT_GT(difference(before, grabView()), 0.002) << "the view shows the trial, not the scene";
  EXPECT_TRUE(child<QLabel>("lab.stability.shown")->text().contains(QStringLiteral("bit for bit")));
  QTest::mouseClick(child<QPushButton>("lab.stability.back"), Qt::LeftButton);
  ASSERT_TRUE(until([this] { return !link.hasGuest(); }));
  EXPECT_TRUE(until([this] { return snapshot().model && snapshot().model->scenario.id == document.scenario().id && snapshot().step == 0; }));
}

TEST_F(Lab, theEffectsPanelSaysWhatStepsTakeAndSwitchesEffects) {
  EXPECT_FALSE(link.meter().isWanted()) << "nobody sees it";
  raise("dock.lab.effects");
  ASSERT_TRUE(until([this] { return link.meter().isWanted(); }));
  link.play();
  EffectsPanel& panel = window->lab().effects();
  ASSERT_TRUE(until([&] { return panel.series().hasSteps() && panel.series().moments().size() >= 3; }));
  auto* effects = child<QTableWidget>("lab.effects.table");
  ASSERT_GT(effects->rowCount(), 6);
  ASSERT_TRUE(until([this] { return child<QTableWidget>("lab.effects.islands")->rowCount() > 0; }));
  EXPECT_TRUE(child<QLabel>("lab.effects.summary")->text().contains(QStringLiteral("A step takes"))) << child<QLabel>("lab.effects.summary")->text().toStdString();
  QTest::qWait(1500);
  shoot("effects");
  auto* contact = child<QComboBox>("lab.effect.contact");
  contact->setFocus();
  QTest::keyClick(contact, Qt::Key_End);
  QTest::keyClick(contact, Qt::Key_Return);
  ASSERT_TRUE(until([this] { return document.scenario().effects.contact == Wish::Off; }));
  ASSERT_TRUE(until([this] { return snapshot().model && !snapshot().model->effectOn("contact"); }));
  EXPECT_TRUE(until([&] { return effects->item(2, 3) && effects->item(2, 3)->text().contains(QStringLiteral("when it was on")); })) << effects->item(2, 3)->text().toStdString();
  action("undo")->trigger();
  EXPECT_EQ(document.scenario().effects.contact, Wish::Auto);
  link.pause();
  raise("dock.lab.accuracy");
  EXPECT_TRUE(until([this] { return !link.meter().isWanted(); }));
}

TEST_F(Lab, aReportNeedsAStudyAndThenIsWritten) {
  child<QDockWidget>("dock.lab.accuracy");
  action("report")->trigger();
  EXPECT_TRUE(child<QLabel>("problem")->text().contains(QStringLiteral("no study"))) << child<QLabel>("problem")->text().toStdString();
  QDir().mkpath(path("small"));
  QFile file(path("small/progress.jsonl"));
  ASSERT_TRUE(file.open(QIODevice::WriteOnly));
  file.write("{\"study\":\"accuracy\",\"scenario\":\"block.scenario.json\",\"dtMs\":5}\n{\"table\":\"settings\",\"row\":{\"setting\":\"scene\",\"family\":\"scene\",\"failure\":\"\",\"windows\":1,"
             "\"inScenario\":true,\"workMedianMs\":2,\"workP95Ms\":null,\"displacementOwnCellsMm\":null}}\n");
  file.close();
  accuracy().bar().openFolder(path("small"));
  QSignalSpy written(&window->lab(), &LabDocks::reportWritten);
  window->lab().writeReport(path("report.html"));
  ASSERT_TRUE(until([&] { return written.count() == 1; }, 60000));
  EXPECT_TRUE(QFile::exists(path("report.html")));
}

}  // namespace
}  // namespace glenoid
