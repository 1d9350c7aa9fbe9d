// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCheckBox>
#include <QComboBox>
#include <QDropEvent>
#include <QHeaderView>
#include <QMimeData>
#include <QPushButton>
#include <QTreeWidget>
#include <QUrl>

#include "editor/ui/ImportDialog.h"
#include "editor/ui/ImportPicture.h"
#include "simcore/file/Ply.h"
#include "tests/editor/ui/GuiTest.h"
#include "tests/simcore/file/TemporaryFolder.h"
#include "tests/simcore/mesh/Shapes.h"

// Import with the mouse and the keyboard.
namespace glenoid {
namespace {

class ImportDialogTest : public GuiTest {
 protected:
  QString put(const std::string& name, const TriMesh& mesh) {
    EXPECT_TRUE(writePly(folder.path(name), mesh).ok());
    return QString::fromStdString(folder.path(name));
  }
  /// As a file manager does it.
  void drop(const QStringList& files) {
    QMimeData data;
    QList<QUrl> urls;
    for (const QString& file : files) urls << QUrl::fromLocalFile(file);
    data.setUrls(urls);
    QDragEnterEvent enter(QPoint(300, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(window.get(), &enter);
    ASSERT_TRUE(enter.isAccepted());
    QDropEvent event(QPointF(300, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
    QCoreApplication::sendEvent(window.get(), &event);
    ASSERT_TRUE(until([this] { return window->findChild<ImportDialog*>() != nullptr; }));
    dialog = window->findChild<ImportDialog*>();
    ASSERT_TRUE(QTest::qWaitForWindowExposed(dialog));
    ASSERT_TRUE(until([this] { return !dialog->session().busy(); }));
  }
  template <class T>
  T* in(const char* name) {
    T* found = dialog->findChild<T*>(QString::fromLatin1(name));
    EXPECT_NE(found, nullptr) << name;
    return found;
  }
  static void click(QWidget* widget, const QPoint& at = {}) {
    QTest::mouseClick(widget, Qt::LeftButton, Qt::NoModifier, at.isNull() ? widget->rect().center() : at);
  }
  /// The box in front of an item's text.
  static void clickBox(QTreeWidget* tree, QTreeWidgetItem* item, int column) {
    const QRect row = tree->visualItemRect(item);
    const int left = tree->header()->sectionViewportPosition(column);
    click(tree->viewport(), QPoint(left + 12, row.center().y()));
  }
  static TriMesh wrongBall() {
    TriMesh ball = shapes::sphere(24);
    for (auto& t : ball.triangles) std::swap(t[0], t[1]);
    ball.triangles.pop_back();
    return ball;
  }
  TemporaryFolder folder;
  ImportDialog* dialog = nullptr;
};

TEST_F(ImportDialogTest, droppedFilesAreJudgedMendedAndAdded) {
  const std::size_t parts = document.joint().parts.size();
  drop({put("humerus.ply", wrongBall()), put("spare.ply", shapes::sphere(20)), QString::fromStdString(folder.put("broken.stl", "solid no"))});
  auto* table = in<QTreeWidget>("import.table");
  ASSERT_EQ(table->topLevelItemCount(), 3);
  EXPECT_EQ(table->topLevelItem(0)->text(0), QStringLiteral("humerus"));
  EXPECT_EQ(table->topLevelItem(0)->text(5), QStringLiteral("Sound"));
  EXPECT_EQ(table->topLevelItem(2)->text(5), QStringLiteral("Failed"));
  EXPECT_EQ(document.joint().parts.size(), parts) << "nothing reaches the document before Import";

  // The findings of the first, with the harmless repairs on.
  click(table->viewport(), table->visualItemRect(table->topLevelItem(0)).center());
  auto* findings = in<QTreeWidget>("import.findings");
  QTreeWidgetItem* holes = nullptr;
  for (int i = 0; i < findings->topLevelItemCount(); ++i)
    if (findings->topLevelItem(i)->data(0, Qt::UserRole).toInt() == static_cast<int>(FindingKind::Holes)) holes = findings->topLevelItem(i);
  ASSERT_NE(holes, nullptr);
  EXPECT_EQ(holes->checkState(1), Qt::Checked);
  // Off: the row says that it is not sound; on again: it is.
  clickBox(findings, holes, 1);
  ASSERT_TRUE(until([&] { return !dialog->session().busy() && table->topLevelItem(0)->text(5) != QStringLiteral("Sound"); }));
  EXPECT_TRUE(in<QLabel>("import.state")->text().contains(QStringLiteral("not sound")));
  for (int i = 0; i < findings->topLevelItemCount(); ++i)
    if (findings->topLevelItem(i)->data(0, Qt::UserRole).toInt() == static_cast<int>(FindingKind::Holes)) clickBox(findings, findings->topLevelItem(i), 1);
  ASSERT_TRUE(until([&] { return !dialog->session().busy() && table->topLevelItem(0)->text(5) == QStringLiteral("Sound"); }));

  // The unit by the keyboard; the size follows.
  auto* unit = in<QComboBox>("import.unit");
  unit->setFocus();
  for (const auto& [key, size] : {std::pair(Qt::Key_Home, "48 × "), std::pair(Qt::Key_Down, "480 × "), std::pair(Qt::Key_Up, "48 × ")}) {
    QTest::keyClick(unit, key);
    ASSERT_TRUE(until([&, wanted = QString::fromUtf8(size)] { return !dialog->session().busy() && in<QLabel>("import.size")->text().startsWith(wanted); }))
        << in<QLabel>("import.size")->text().toStdString();
  }
  click(in<QPushButton>("import.forAll"));
  ASSERT_TRUE(until([&] { return !dialog->session().busy(); }));
  EXPECT_EQ(dialog->session().rows()[1].metres, 1e-3);

  // The second one stays out.
  clickBox(table, table->topLevelItem(1), 0);
  EXPECT_FALSE(dialog->session().rows()[1].wanted);
  ASSERT_TRUE(in<QPushButton>("import.accept")->isEnabled());
  click(in<QPushButton>("import.accept"));
  ASSERT_TRUE(until([&] { return window->findChild<ImportDialog*>() == nullptr; }));
  ASSERT_EQ(document.joint().parts.size(), parts + 1);
  EXPECT_EQ(document.joint().parts.back().id, "humerus");
  EXPECT_EQ(child<QTreeWidget>("partTree")->topLevelItemCount(), static_cast<int>(parts) + 1);
  ASSERT_TRUE(until([this] { return !link.isCompiling() && snapshot().model && snapshot().model->joint.parts.size() == document.joint().parts.size(); }))
      << "the joint with the new part runs";
  window->activateWindow();  // no window manager gives the focus back
  ASSERT_TRUE(QTest::qWaitForWindowActive(window.get()));
  QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(document.joint().parts.size(), parts);
  QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_EQ(document.joint().parts.size(), parts + 1);
}

TEST_F(ImportDialogTest, thePictureShowsTheFlawAndTurns) {
  TriMesh ball = wrongBall();
  drop({put("a.ply", ball)});
  auto* picture = in<ImportPicture>("import.picture");
  auto* findings = in<QTreeWidget>("import.findings");
  const auto choose = [&](FindingKind kind) {
    for (int i = 0; i < findings->topLevelItemCount(); ++i) {
      QTreeWidgetItem* item = findings->topLevelItem(i);
      if (item->data(0, Qt::UserRole).toInt() == static_cast<int>(kind)) click(findings->viewport(), findings->visualItemRect(item).center() - QPoint(findings->width() / 4, 0));
    }
    QTest::qWait(50);
  };
  choose(FindingKind::InsideOut);
  const QImage all = picture->grab().toImage();
  choose(FindingKind::Holes);
  const QImage holes = picture->grab().toImage();
  EXPECT_GT(difference(all.convertToFormat(QImage::Format_RGB32), holes.convertToFormat(QImage::Format_RGB32)), 0.05) << "all of it was orange, now three triangles";
  QTest::mousePress(picture, Qt::LeftButton, Qt::NoModifier, QPoint(100, 100));
  QTest::mouseMove(picture, QPoint(180, 140));
  QTest::mouseRelease(picture, Qt::LeftButton, Qt::NoModifier, QPoint(180, 140));
  QTest::qWait(50);
  EXPECT_GT(difference(holes.convertToFormat(QImage::Format_RGB32), picture->grab().toImage().convertToFormat(QImage::Format_RGB32)), 0.01);
  QTest::keyClick(dialog, Qt::Key_Escape);
  ASSERT_TRUE(until([&] { return window->findChild<ImportDialog*>() == nullptr; }));
  EXPECT_EQ(document.undoStack().count(), 0);
}

TEST_F(ImportDialogTest, aReaderThatHangsIsStoppedByTheButton) {
  ::setenv("GLENOID_IMPORT_TEST", "hang", 1);
  window->importSurfaceFiles({put("a.ply", shapes::sphere(24))});
  dialog = window->findChild<ImportDialog*>();
  ASSERT_NE(dialog, nullptr);
  ASSERT_TRUE(QTest::qWaitForWindowExposed(dialog));
  EXPECT_TRUE(dialog->session().busy());
  EXPECT_FALSE(in<QPushButton>("import.accept")->isEnabled());
  click(in<QPushButton>("import.stop"));
  EXPECT_FALSE(dialog->session().busy());
  EXPECT_EQ(in<QTreeWidget>("import.table")->topLevelItem(0)->text(5), QStringLiteral("Failed"));
  ::unsetenv("GLENOID_IMPORT_TEST");
  click(in<QPushButton>("import.cancel"));
  ASSERT_TRUE(until([&] { return window->findChild<ImportDialog*>() == nullptr; }));
}

TEST_F(ImportDialogTest, whatIsNoSurfaceCannotBeDropped) {
  QMimeData data;
  data.setUrls({QUrl::fromLocalFile(QString::fromStdString(folder.put("notes.txt", "x")))});
  QDragEnterEvent enter(QPoint(300, 300), Qt::CopyAction, &data, Qt::LeftButton, Qt::NoModifier);
  enter.ignore();
  QCoreApplication::sendEvent(window.get(), &enter);
  EXPECT_FALSE(enter.isAccepted());
}

}  // namespace
}  // namespace glenoid
