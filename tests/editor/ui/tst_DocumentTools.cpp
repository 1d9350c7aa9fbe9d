// SPDX-License-Identifier: GPL-3.0-or-later
// Undo, redo, saving, problems, jobs and recovery with the mouse and the keys of a person.
#include <QCheckBox>
#include <QDialogButtonBox>
#include <QDoubleSpinBox>
#include <QElapsedTimer>
#include <QFileDialog>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QMenuBar>
#include <QMessageBox>
#include <QProcess>
#include <QProgressBar>
#include <QPushButton>
#include <QSpinBox>
#include <QTabBar>
#include <QTemporaryDir>
#include <QTimer>
#include <QToolButton>
#include <QTreeWidget>
#include <QUndoView>
#include <atomic>
#include <csignal>

#include "app/StudioScene.h"
#include "editor/core/AutosaveStore.h"
#include "editor/core/PartEdits.h"
#include "simcore/scene/JointFile.h"
#include "editor/ui/ExportDialog.h"
#include "tests/editor/ui/GuiTest.h"
#include "tests/editor/ui/KilledEditor.h"

namespace glenoid {
namespace {

class DocumentTools : public GuiTest {
 protected:
  Result<Scene> load(const std::string& path) override {
    if (path.find('/') != std::string::npos) return loadScene(path);
    Scene scene = blockScene();
    scene.scenario.joint = "block.joint";
    if (path == "inside out")
      for (Part& part : scene.joint.parts)
        if (part.id == "plate") {
          TriMesh mesh = *part.visual;
          for (auto& t : mesh.triangles) std::swap(t[0], t[1]);
          part.visual = std::make_shared<const TriMesh>(mesh);
        }
    return scene;
  }
  Result<Done> save(const Scene& scene, const std::string& path) override { return saveScene(scene, path); }

  std::string hash() const { return jointHash(document.joint()); }
  const Part& part(const std::string& id) const { return document.joint().parts[findPart(document.joint(), id)]; }

  /// Once a dialog of this kind is open, does something with it; answers whether it came.
  template <class Dialog, class Act>
  std::shared_ptr<bool> whenOpen(Act act) {
    auto came = std::make_shared<bool>(false);
    auto* timer = new QTimer(window.get());
    timer->setObjectName(QStringLiteral("whenOpen"));
    QObject::connect(timer, &QTimer::timeout, timer, [=] {
      auto* dialog = qobject_cast<Dialog*>(QApplication::activeModalWidget());
      if (!dialog || !dialog->isVisible()) return;
      timer->stop();
      timer->deleteLater();
      *came = true;
      act(dialog);
    });
    timer->start(50);
    return came;
  }
  /// Types a path into the file dialog that comes, and clicks its button.
  std::shared_ptr<bool> typeIntoFileDialog(const QString& path) {
    return whenOpen<QFileDialog>([path](QFileDialog* dialog) {
      // Its folder is still being read, and a list of completions may come up over the button and swallow the click: as a
      // person does, look whether the name stands there, type it again, click again.
      auto* again = new QTimer(dialog);
      QObject::connect(again, &QTimer::timeout, dialog, [dialog, path] {
        if (QWidget* completions = QApplication::activePopupWidget()) return void(completions->close());
        auto* name = dialog->findChild<QLineEdit*>(QStringLiteral("fileNameEdit"));
        if (name->text() != path) {
          name->setFocus();
          name->selectAll();
          QTest::keyClicks(name, path);
          return;
        }
        const auto accept = dialog->acceptMode() == QFileDialog::AcceptSave ? QDialogButtonBox::Save : QDialogButtonBox::Open;
        QTest::mouseClick(dialog->findChild<QDialogButtonBox*>()->button(accept), Qt::LeftButton);
      });
      again->start(150);
    });
  }
  /// Brings a dock that lies behind others to the front by a click on its tab.
  void clickTab(const QString& title) {
    for (QTabBar* tabs : window->findChildren<QTabBar*>()) {
      for (int i = 0; i < tabs->count(); ++i) {
        if (tabs->tabText(i) != title || !tabs->isVisible()) continue;
        QTest::mouseClick(tabs, Qt::LeftButton, {}, tabs->tabRect(i).center());
        return;
      }
    }
    FAIL() << "no tab " << title.toStdString();
  }
  /// After a dialog the window has the keys again; with no window manager nobody else sees to it.
  void backToWindow() {
    window->activateWindow();
    window->setFocus();
    EXPECT_TRUE(until([this] { return QApplication::activeWindow() == window.get(); }));
  }
  static void clickRow(QAbstractItemView* view, int row, bool twice = false) {
    const QPoint at = view->visualRect(view->model()->index(row, 0)).center();
    QTest::mouseClick(view->viewport(), Qt::LeftButton, {}, at);
    if (twice) QTest::mouseDClick(view->viewport(), Qt::LeftButton, {}, at);
  }
};

TEST_F(DocumentTools, everythingIsUndoneAndRedoneByKeyboard) {
  const std::string before = hash();
  // Stiffness typed into the field of the part that was clicked, a solver from the menu, and edits from elsewhere.
  const auto at = window->view()->toScreen(Vec3(0, 0.02, 0.02));
  ASSERT_TRUE(at);
  QTest::mouseClick(window->view(), Qt::LeftButton, {}, at->toPoint());
  ASSERT_EQ(selection.current(), "block");
  auto* young = child<QDoubleSpinBox>("young.tissue");
  young->setFocus();
  young->selectAll();
  QTest::keyClicks(young, QStringLiteral("80"));
  QTest::keyClick(young, Qt::Key_Return);
  EXPECT_DOUBLE_EQ(document.joint().materials[findMaterial(document.joint(), "tissue")].youngsModulus, 80e3);
  document.endGesture();
  action("profile.reference")->trigger();
  ASSERT_TRUE(renamePart(document, "block", QStringLiteral("Brick")));
  ASSERT_TRUE(setPartColor(document, "plate", {0.1f, 0.2f, 0.3f}));
  ASSERT_TRUE(addExclusion(document, {"block", "plate", "for the test"}));
  const int steps = document.undoStack().count();
  EXPECT_GE(steps, 5);
  const std::string after = hash();
  EXPECT_TRUE(window->isWindowModified());
  window->setFocus();
  for (int i = 0; i < steps; ++i) QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_FALSE(document.undoStack().canUndo());
  EXPECT_EQ(hash(), before);
  EXPECT_EQ(document.scenario().profile, Profile::Direct);
  EXPECT_FALSE(window->isWindowModified());
  QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(hash(), before) << "one more does nothing";
  for (int i = 0; i < steps; ++i) QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_FALSE(document.undoStack().canRedo());
  EXPECT_EQ(hash(), after);
  EXPECT_EQ(document.scenario().profile, Profile::Reference);
}

TEST_F(DocumentTools, theHistoryShowsEachStepAndAClickGoesThere) {
  const std::string before = hash();
  ASSERT_TRUE(renamePart(document, "block", QStringLiteral("Brick")));
  const std::string middle = hash();
  ASSERT_TRUE(renamePart(document, "plate", QStringLiteral("Table")));
  clickTab(QStringLiteral("History"));
  auto* history = child<QUndoView>("history");
  ASSERT_TRUE(until([&] { return history->isVisible(); }));
  EXPECT_EQ(history->accessibleName(), QStringLiteral("History of changes"));
  ASSERT_EQ(history->model()->rowCount(), 3) << "as opened, and two steps";
  EXPECT_EQ(history->model()->index(0, 0).data().toString(), QStringLiteral("As it was opened"));
  EXPECT_TRUE(history->model()->index(2, 0).data().toString().contains(QStringLiteral("plate")));
  clickRow(history, 1);
  EXPECT_EQ(hash(), middle);
  clickRow(history, 0);
  EXPECT_EQ(hash(), before);
  clickRow(history, 2);
  EXPECT_EQ(part("plate").name, "Table");
  setLanguage(QStringLiteral("es"));
  EXPECT_TRUE(until([&] { return history->model()->index(0, 0).data().toString() == QStringLiteral("Como se abrió"); }));
}

TEST_F(DocumentTools, savedLoadedAndRunByKeyboard) {
  QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("mine.scenario.json"));
  ASSERT_TRUE(renamePart(document, "block", QStringLiteral("Brick")));
  const std::string saved = hash();
  auto came = typeIntoFileDialog(path);
  QTest::keyClick(window.get(), Qt::Key_S, Qt::ControlModifier);
  ASSERT_TRUE(*came);
  EXPECT_TRUE(QFile::exists(path));
  EXPECT_FALSE(window->isWindowModified());
  // Undo goes on across the save; then the saved scene comes back from disk.
  backToWindow();
  QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_NE(hash(), saved);
  EXPECT_TRUE(window->isWindowModified());
  auto asked = whenOpen<QMessageBox>([](QMessageBox* box) { QTest::mouseClick(box->button(QMessageBox::Discard), Qt::LeftButton); });
  came = std::make_shared<bool>(false);
  QObject::connect(window.get(), &MainWindow::sceneOpened, window.get(), [came] { *came = true; });
  typeIntoFileDialog(path);
  QTest::keyClick(window.get(), Qt::Key_O, Qt::ControlModifier);
  EXPECT_TRUE(*asked);
  ASSERT_TRUE(until([&] { return *came; }));
  backToWindow();
  EXPECT_EQ(document.path(), path);
  EXPECT_EQ(hash(), saved);
  ASSERT_TRUE(until([this] { return snapshot().model && snapshot().model->jointHash == hash() && snapshot().step == 0; }));
  QTest::keyClick(window.get(), Qt::Key_Space);
  ASSERT_TRUE(until([this] { return snapshot().step > 20; }));
  // Editing goes on while it runs: the run keeps its time, and undo does not rewind it.
  const long step = snapshot().step;
  document.setYoungsModulus("tissue", 90e3);
  QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier);
  ASSERT_TRUE(until([&] { return snapshot().step > step + 20; }));
  QTest::keyClick(window.get(), Qt::Key_Space);
}

TEST_F(DocumentTools, partsAreNamedNumberedAndDeleted) {
  const std::string before = hash();
  selection.select("block");
  auto* name = child<QLineEdit>("partName");
  ASSERT_TRUE(name);
  name->setFocus();
  name->selectAll();
  QTest::keyClicks(name, QStringLiteral("Infraspinatus"));
  QTest::keyClick(name, Qt::Key_Return);
  EXPECT_EQ(part("block").name, "Infraspinatus");
  const int number = part("block").number, taken = part("plate").number;
  auto* box = child<QSpinBox>("partNumber");
  ASSERT_TRUE(box);
  box->setFocus();
  box->selectAll();
  QTest::keyClicks(box, QString::number(taken));
  QTest::keyClick(box, Qt::Key_Return);
  EXPECT_EQ(part("block").number, number) << "the number of another part is put back";
  box = child<QSpinBox>("partNumber");
  box->setFocus();
  box->selectAll();
  QTest::keyClicks(box, QStringLiteral("77"));
  QTest::keyClick(box, Qt::Key_Return);
  EXPECT_EQ(part("block").number, 77);
  backToWindow();
  selection.select("block");
  QTest::keyClick(window.get(), Qt::Key_Delete);
  EXPECT_LT(findPart(document.joint(), "block"), 0);
  EXPECT_TRUE(selection.ids().empty());
  while (document.undoStack().canUndo()) QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(hash(), before);
}

TEST_F(DocumentTools, aProblemIsShownAndFixedFromTheList) {
  window->openScene(QStringLiteral("inside out"));
  clickTab(QStringLiteral("Problems"));
  auto* list = child<QListWidget>("problemList");
  // The list of the scene before stands there until the new one has been opened and looked at.
  ASSERT_TRUE(until([&] {
    return list->count() > 1 && !window->problems().isChecking() && list->item(0)->text().contains(QStringLiteral("wound inwards"));
  })) << "it hangs on nothing, and more";
  ASSERT_TRUE(list->item(0)->text().contains(QStringLiteral("wound inwards"))) << list->item(0)->text().toStdString();
  EXPECT_FALSE(list->item(0)->icon().isNull());
  EXPECT_TRUE(list->item(0)->data(Qt::AccessibleTextRole).toString().startsWith(QStringLiteral("Error: ")));
  const std::string before = hash();
  const Vec3 eye = window->view()->view().eye_W;
  clickRow(list, 0, true);
  EXPECT_EQ(selection.current(), "plate") << "a double click selects the part";
  EXPECT_GT((window->view()->view().eye_W - eye).norm(), 1e-3) << "and brings it into view";
  auto* fix = child<QPushButton>("fixProblem");
  EXPECT_TRUE(child<QLabel>("fixAdvice")->text().contains(QStringLiteral("Turn the visual surface")));
  QTest::mouseClick(fix, Qt::LeftButton);
  ASSERT_TRUE(until([this] { return document.undoStack().count() == 1; }));
  ASSERT_TRUE(until([&] { return !window->problems().isChecking(); }));
  for (int row = 0; row < list->count(); ++row) EXPECT_FALSE(list->item(row)->text().contains(QStringLiteral("wound inwards")));
  EXPECT_NE(hash(), before);
  QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(hash(), before);
  ASSERT_TRUE(until([&] { return !window->problems().isChecking(); }));
  EXPECT_TRUE(list->item(0)->text().contains(QStringLiteral("wound inwards")));
  setLanguage(QStringLiteral("es"));
  EXPECT_TRUE(until([&] { return list->item(0)->text().contains(QStringLiteral("hacia dentro")); })) << list->item(0)->text().toStdString();
}

TEST_F(DocumentTools, aJobIsShownAndStoppedInTheStatusBar) {
  auto* bar = child<QWidget>("jobsBar");
  EXPECT_FALSE(bar->isVisible());
  const std::string before = hash();
  std::vector<JobSystem::End> ends;
  QObject::connect(&window->jobs(), &JobSystem::ended, window.get(), [&](int, JobSystem::End end, const QString&) { ends.push_back(end); });
  window->jobs().startJoint(QStringLiteral("Count to a million"), [joint = document.joint()](JobContext& context) -> Result<Joint> {
    context.phase(QStringLiteral("thousands"));
    Joint changed = joint;
    changed.name = "changed";
    for (int i = 0; i < 2000 && context.progress(i / 2000.0); ++i) QThread::msleep(5);
    return changed;
  });
  ASSERT_TRUE(until([&] { return bar->isVisible() && child<QProgressBar>("jobProgress")->value() > 50; }));
  EXPECT_TRUE(child<QLabel>("jobText")->text().contains(QStringLiteral("Count to a million: thousands")));
  QElapsedTimer clock;
  clock.start();
  QTest::mouseClick(child<QToolButton>("cancelJob"), Qt::LeftButton);
  ASSERT_TRUE(until([&] { return !ends.empty(); }));
  EXPECT_LT(clock.elapsed(), 200);
  EXPECT_EQ(ends[0], JobSystem::End::Cancelled);
  EXPECT_FALSE(bar->isVisible());
  EXPECT_EQ(hash(), before);
  EXPECT_EQ(document.undoStack().count(), 0);
}

TEST_F(DocumentTools, exportSaysWhatIsLost) {
  QTemporaryDir folder;
  const QString path = folder.filePath(QStringLiteral("block.msh"));
  QString said;
  auto box = whenOpen<QMessageBox>([&said](QMessageBox* message) {
    said = message->informativeText();
    QTest::keyClick(message, Qt::Key_Return);
  });
  const auto typed = typeIntoFileDialog(path);
  const auto asked = whenOpen<ExportDialog>([](ExportDialog* dialog) { QTest::keyClick(dialog, Qt::Key_Return); });
  QTest::keyClick(window.get(), Qt::Key_E, Qt::ControlModifier | Qt::ShiftModifier);
  ASSERT_TRUE(*typed);
  ASSERT_TRUE(until([&] { return *asked; }));
  ASSERT_TRUE(until([&] { return *box; }));
  EXPECT_TRUE(QFile::exists(path));
  EXPECT_TRUE(said.contains(QStringLiteral("Rigid parts are left out: 1."))) << said.toStdString();
}

/// What another program left that was killed after an edit.
class Recovery : public DocumentTools {
 protected:
  void SetUp() override {
    DocumentTools::SetUp();
    QProcess killed;
    killed.start(QCoreApplication::applicationFilePath(), {QString::fromLatin1(kKilledEditor), root()});
    ASSERT_TRUE(killed.waitForStarted());
    ASSERT_TRUE(killed.waitForReadyRead(20000)) << killed.readAllStandardError().toStdString();
    ASSERT_EQ(killed.readLine().trimmed().toStdString(), "safe");
    EXPECT_TRUE(abandonedSessions(root()).empty()) << "it still runs";
    ::kill(static_cast<pid_t>(killed.processId()), SIGKILL);
    ASSERT_TRUE(killed.waitForFinished());
  }
  QString root() const { return folder.filePath(QStringLiteral("autosave")); }
  QTemporaryDir folder;
};

TEST_F(Recovery, afterAKillTheWorkIsOfferedAndComesBack) {
  auto came = whenOpen<QDialog>([](QDialog* dialog) {
    ASSERT_EQ(dialog->objectName(), QStringLiteral("recoverDialog"));
    auto* list = dialog->findChild<QTreeWidget*>(QStringLiteral("recoverList"));
    ASSERT_EQ(list->topLevelItemCount(), 1);
    EXPECT_EQ(list->topLevelItem(0)->text(1), QStringLiteral("Block on a plate"));
    EXPECT_EQ(list->topLevelItem(0)->text(2), QStringLiteral("/somewhere/block.scenario.json"));
    EXPECT_FALSE(list->topLevelItem(0)->text(0).isEmpty());
    QTest::mouseClick(dialog->findChild<QPushButton*>(QStringLiteral("recover")), Qt::LeftButton);
  });
  window->offerRecovery(root());
  ASSERT_TRUE(*came);
  EXPECT_EQ(part("block").name, "Saved from the crash");
  EXPECT_TRUE(window->isWindowModified()) << "it lies in no project yet";
  ASSERT_TRUE(until([this] { return snapshot().model && snapshot().model->jointHash == hash(); })) << "and it can be run";
}

TEST_F(Recovery, declinedWorkIsNotOfferedAgainAndFoundInTheMenu) {
  const std::string before = hash();
  auto came = whenOpen<QDialog>([](QDialog* dialog) { QTest::keyClick(dialog, Qt::Key_Escape); });
  window->offerRecovery(root());
  ASSERT_TRUE(*came);
  EXPECT_EQ(hash(), before);
  const auto again = whenOpen<QDialog>([](QDialog* dialog) { QTest::keyClick(dialog, Qt::Key_Escape); });
  window->offerRecovery(root());
  EXPECT_FALSE(*again) << "declined once, it waits in the menu";
  qDeleteAll(window->findChildren<QTimer*>(QStringLiteral("whenOpen")));
  came = whenOpen<QDialog>([](QDialog* dialog) {
    QTest::mouseClick(dialog->findChild<QPushButton*>(QStringLiteral("recover")), Qt::LeftButton);
  });
  action("recover")->trigger();
  ASSERT_TRUE(*came);
  EXPECT_EQ(part("block").name, "Saved from the crash");
}

}  // namespace
}  // namespace glenoid
