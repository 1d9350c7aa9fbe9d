// SPDX-License-Identifier: GPL-3.0-or-later
// Nodes picked in the window, coupled, edited again and undone.
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLabel>
#include <QPushButton>
#include <QScrollArea>
#include <QTreeWidget>

#include "editor/ui/AuthorDocks.h"
#include "simcore/mesh/TrianglePatch.h"
#include "tests/editor/ui/GuiTest.h"
#include "tests/scenes/NodeScenes.h"

namespace glenoid {
namespace {

/// The block on its plate: 27 nodes, three by three of them on its front.
class NodeTools : public GuiTest {
 protected:
  void SetUp() override {
    GuiTest::SetUp();
    if (HasFatalFailure()) return;
    View view;
    view.eye_W = Vec3(0.031, 0.055, 0.3);
    view.target_W = Vec3(0, 0.02, 0);
    view.fieldOfView = 0.4;
    window->view()->setView(view);
    child<QDockWidget>("dock.couplings")->raise();
    selection.select("block");
    settle();
  }
  Authoring& authoring() { return window->author().authoring(); }
  std::vector<int> where(const std::function<bool(const Vec3&)>& holds) { return scenes::nodesWhere(document.joint().parts[1], holds); }
  QPoint pixel(const Vec3& p) const { return window->view()->toScreen(p)->toPoint(); }
  void drag(const QPoint& from, const QPoint& to, Qt::KeyboardModifiers modifiers = {}) {
    QTest::mousePress(window->view(), Qt::LeftButton, modifiers, from);
    for (int i = 0; i <= 4; ++i) {
      const QPoint p = from + (to - from) * i / 4;
      QMouseEvent move(QEvent::MouseMove, p, window->view()->mapToGlobal(p), Qt::NoButton, Qt::LeftButton, modifiers);
      QApplication::sendEvent(window->view(), &move);
    }
    QTest::mouseRelease(window->view(), Qt::LeftButton, modifiers, to);
  }
  void press(const char* button) {
    auto* found = child<QPushButton>(button);
    ASSERT_TRUE(found->isEnabled()) << button;
    child<QScrollArea>("couplings")->ensureWidgetVisible(found);
    QTest::mouseClick(found, Qt::LeftButton);
  }
};

TEST_F(NodeTools, pickedNodesAreSeenCoupledEditedAndUndone) {
  const QImage before = grabView();
  QTest::keyClick(window.get(), Qt::Key_N);
  ASSERT_EQ(authoring().tool(), Authoring::Tool::Select);
  ASSERT_EQ(authoring().picking(), Authoring::Picking::Nodes);
  EXPECT_TRUE(action("author.nodes")->isChecked());
  EXPECT_EQ(child<QComboBox>("couplings.what")->currentIndex(), 1);
  EXPECT_FALSE(child<QDoubleSpinBox>("couplings.stiffness")->isVisible());
  EXPECT_TRUE(child<QDoubleSpinBox>("couplings.nodeStiffness")->isVisible());
  settle();
  const QImage dots = grabView();
  EXPECT_GT(difference(before, dots), 2e-4) << "dots are seen while the tool is on";

  // By click, box and brush; Shift adds, Ctrl takes away, each a step.
  QTest::keyClick(window.get(), Qt::Key_C);
  const Vec3 corner(-0.02, 0.0005, 0.02), beside(0, 0.0005, 0.02), above(-0.02, 0.0205, 0.02);
  QTest::mouseClick(window->view(), Qt::LeftButton, {}, pixel(corner));
  ASSERT_EQ(authoring().selectedNodes(), where([&](const Vec3& p) { return (p - corner).norm() < 1e-9; }));
  EXPECT_FALSE(child<QPushButton>("couplings.couple")->isEnabled()) << "one cannot hold";
  QTest::mouseClick(window->view(), Qt::LeftButton, Qt::ShiftModifier, pixel(beside));
  QTest::mouseClick(window->view(), Qt::LeftButton, Qt::ShiftModifier, pixel(above));
  const std::vector<int> three = authoring().selectedNodes();
  ASSERT_EQ(three.size(), 3u);
  settle();
  EXPECT_GT(difference(dots, grabView()), 2e-5) << "in another colour";
  QTest::keyClick(window.get(), Qt::Key_B);
  drag(pixel(above) + QPoint(-12, -12), pixel(above) + QPoint(12, 12), Qt::ControlModifier);
  EXPECT_EQ(authoring().selectedNodes().size(), 2u);
  EXPECT_TRUE(child<QLabel>("couplings.selected")->text().contains(QStringLiteral("too few")));
  QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(authoring().selectedNodes(), three) << "each stroke is a step";

  child<QDoubleSpinBox>("couplings.nodeStiffness")->setValue(0.25);
  EXPECT_TRUE(child<QLabel>("couplings.asPressure")->text().startsWith(QStringLiteral("0.75"))) << "three springs";
  press("couplings.couple");
  ASSERT_EQ(document.joint().couplings.size(), 1u);
  EXPECT_EQ(document.joint().couplings[0].nodesA, three);
  EXPECT_DOUBLE_EQ(document.joint().couplings[0].stiffnessPerNode, 250);
  EXPECT_TRUE(document.joint().parts[1].regions.empty());
  auto* list = child<QTreeWidget>("couplings.list");
  ASSERT_TRUE(until([&] { return list->topLevelItemCount() == 1 && !list->topLevelItem(0)->text(2).isEmpty(); })) << "figures come from a worker";
  EXPECT_EQ(list->topLevelItem(0)->text(2), QStringLiteral("3"));
  ASSERT_TRUE(until([&] { return snapshot().model->springs.size() == 3; })) << "the run has taken it";

  // Again: another stiffness, then four nodes instead of three.
  auto* own = child<QDoubleSpinBox>("couplings.ownStiffness");
  EXPECT_TRUE(own->suffix().contains(QStringLiteral("per node")));
  own->setValue(0.5);
  EXPECT_DOUBLE_EQ(document.joint().couplings[0].stiffnessPerNode, 500);
  QTest::keyClick(window.get(), Qt::Key_C);
  QTest::mouseClick(window->view(), Qt::LeftButton, {}, pixel(Vec3(0.02, 0.0405, 0.02)));
  press("couplings.takeNodes");
  EXPECT_EQ(authoring().selectedNodes(), three);
  QTest::mouseClick(window->view(), Qt::LeftButton, Qt::ShiftModifier, pixel(Vec3(0, 0.0205, 0.02)));
  press("couplings.replaceNodes");
  EXPECT_EQ(document.joint().couplings[0].nodesA.size(), 4u);
  ASSERT_TRUE(until([&] { return snapshot().model->springs.size() == 4; }));
  const auto four = document.joint().couplings[0].nodesA;
  QUndoStack& undo = document.undoStack();
  while (undo.canUndo()) QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(document.joint().couplings.empty());
  EXPECT_TRUE(authoring().selectedNodes().empty());
  undo.setIndex(undo.count());
  ASSERT_EQ(document.joint().couplings.size(), 1u);
  EXPECT_EQ(document.joint().couplings[0].nodesA, four);
}

TEST_F(NodeTools, whatIsNearGrowsAndTurnsBackToTriangles) {
  QTest::keyClick(window.get(), Qt::Key_N);
  child<QDoubleSpinBox>("couplings.within")->setValue(0.6);  // the gap is half a millimetre
  press("couplings.near");
  const std::vector<int> under = where([](const Vec3& p) { return p.y() < 1e-3; });
  ASSERT_EQ(under.size(), 9u);
  ASSERT_TRUE(until([&] { return authoring().selectedNodes() == under; })) << "the underside's nodes";
  QTest::keyClick(window.get(), Qt::Key_Up, Qt::ControlModifier);
  EXPECT_GT(authoring().selectedNodes().size(), 9u);
  QTest::keyClick(window.get(), Qt::Key_I, Qt::ControlModifier);
  EXPECT_EQ(common(authoring().selectedNodes(), under), std::vector<int>());
  QTest::keyClick(window.get(), Qt::Key_A, Qt::ControlModifier | Qt::ShiftModifier);
  EXPECT_FALSE(authoring().anySelected());
  child<QComboBox>("couplings.what")->setCurrentIndex(0);
  EXPECT_EQ(authoring().picking(), Authoring::Picking::Triangles);
  EXPECT_TRUE(action("author.triangles")->isChecked());
  EXPECT_TRUE(child<QDoubleSpinBox>("couplings.stiffness")->isVisible());
  // The plate is rigid: there is nothing to pick, and the panel says so.
  authoring().setTarget("plate", SurfaceKind::Visual);
  QTest::keyClick(window.get(), Qt::Key_N);
  EXPECT_TRUE(child<QLabel>("couplings.selected")->text().contains(QStringLiteral("rigid")));
  EXPECT_FALSE(child<QPushButton>("couplings.couple")->isEnabled());
}

}  // namespace
}  // namespace glenoid
