// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCheckBox>
#include <QComboBox>
#include <QDockWidget>
#include <QDoubleSpinBox>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QScrollArea>
#include <QTreeWidget>
#include <map>

#include "editor/ui/AuthorDocks.h"
#include "simcore/mesh/TrianglePatch.h"
#include "tests/editor/ui/GuiTest.h"

namespace glenoid {
namespace {

/// The whole window with the block on its plate, seen from a little below, so that the block's side is in sight.
class CouplingTools : public GuiTest {
 protected:
  void SetUp() override {
    GuiTest::SetUp();
    if (HasFatalFailure()) return;
    View view;
    view.eye_W = Vec3(0.03, 0.05, 0.3);
    view.target_W = Vec3(0, 0.02, 0);
    view.fieldOfView = 0.4;
    window->view()->setView(view);
    child<QDockWidget>("dock.couplings")->raise();
    settle();
  }
  Authoring& authoring() { return window->author().authoring(); }
  QPoint pixel(double x, double y, double z = 0.02) const {
    return window->view()->toScreen(Vec3(x, y, z))->toPoint();
  }
  void paint(const std::vector<QPoint>& way, Qt::KeyboardModifiers modifiers = {}) {
    QTest::mousePress(window->view(), Qt::LeftButton, modifiers, way.front());
    for (const QPoint& p : way) {
      QMouseEvent move(QEvent::MouseMove, p, window->view()->mapToGlobal(p), Qt::NoButton, Qt::LeftButton, modifiers);
      QApplication::sendEvent(window->view(), &move);
      QTest::qWait(5);
    }
    QTest::mouseRelease(window->view(), Qt::LeftButton, modifiers, way.back());
  }
  void press(const char* button) {
    auto* found = child<QPushButton>(button);
    ASSERT_TRUE(found->isEnabled()) << button;
    child<QScrollArea>("couplings")->ensureWidgetVisible(found);
    QTest::mouseClick(found, Qt::LeftButton);
  }
};

TEST_F(CouplingTools, aPaintedRegionBecomesACouplingAndGoesAgain) {
  selection.select("block");
  EXPECT_EQ(authoring().part(), "block");
  const QImage before = grabView();
  QTest::keyClick(window.get(), Qt::Key_P);
  ASSERT_EQ(authoring().tool(), Authoring::Tool::Select);
  EXPECT_TRUE(action("author.brush")->isChecked());
  paint({pixel(-0.015, 0.006), pixel(-0.005, 0.006), pixel(0.005, 0.006), pixel(0.015, 0.006)});
  const std::vector<int> row = authoring().selected();
  ASSERT_GE(row.size(), 4u);
  settle();
  EXPECT_GT(difference(before, grabView()), 0.002) << "what is selected is seen";
  ASSERT_TRUE(until([this] { return authoring().nodes().size() >= 4; })) << "a soft part is held over its cells";
  for (const Vec3& node : authoring().nodes()) EXPECT_NEAR(node.z(), 0.02, 1e-9) << "points of the face";

  paint({pixel(-0.015, 0.016), pixel(0.015, 0.016)}, Qt::ShiftModifier);
  EXPECT_GT(authoring().selected().size(), row.size());
  paint({pixel(-0.015, 0.016), pixel(0.015, 0.016)}, Qt::ControlModifier);
  EXPECT_LE(authoring().selected().size(), row.size());
  QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier);
  QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(authoring().selected(), row) << "each stroke is a step";

  child<QDoubleSpinBox>("couplings.stiffness")->setValue(2);
  child<QLineEdit>("couplings.reason")->setText(QStringLiteral("glued for a test"));
  press("couplings.couple");
  ASSERT_EQ(document.joint().couplings.size(), 1u);
  const Coupling coupling = document.joint().couplings[0];
  EXPECT_EQ(coupling.partA, "block");
  EXPECT_EQ(coupling.partB, "plate");
  EXPECT_EQ(coupling.reason, "glued for a test");
  EXPECT_DOUBLE_EQ(coupling.stiffnessPerArea, 2e7);
  EXPECT_EQ(trianglesOf(*findRegion(document.joint().parts[1], coupling.regionA)), row);
  auto* list = child<QTreeWidget>("couplings.list");
  ASSERT_EQ(list->topLevelItemCount(), 1);
  ASSERT_TRUE(until([&] { return !list->topLevelItem(0)->text(2).isEmpty(); })) << "figures come from a worker";
  ASSERT_TRUE(until([&] { return !snapshot().model->springs.empty(); })) << "the run has taken it";
  EXPECT_EQ(list->topLevelItem(0)->text(2), QString::number(snapshot().model->springs.size()));

  child<QDoubleSpinBox>("couplings.ownStiffness")->setValue(5);
  EXPECT_DOUBLE_EQ(document.joint().couplings[0].stiffnessPerArea, 5e7);
  press("couplings.remove");
  EXPECT_TRUE(document.joint().couplings.empty());
  QUndoStack& undo = document.undoStack();
  while (undo.canUndo()) QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_TRUE(document.joint().couplings.empty());
  EXPECT_TRUE(document.joint().parts[1].regions.empty());
  EXPECT_TRUE(authoring().selected().empty());
  undo.setIndex(undo.count() - 1);
  ASSERT_EQ(document.joint().couplings.size(), 1u);
  EXPECT_DOUBLE_EQ(document.joint().couplings[0].stiffnessPerArea, 5e7);
  EXPECT_EQ(authoring().selected(), row);
}

TEST_F(CouplingTools, whatIsNearIsBoundAndItsCollisionProposedOff) {
  selection.select("block");
  QTest::keyClick(window.get(), Qt::Key_E);
  auto* within = child<QDoubleSpinBox>("couplings.within");
  within->setValue(0.6);  // the gap is half a millimetre
  press("couplings.near");
  ASSERT_TRUE(until([this] { return authoring().selected().size() == 32; })) << "the block's underside";
  press("couplings.couple");
  ASSERT_EQ(document.joint().couplings.size(), 1u);
  QPushButton* exclude = nullptr;
  ASSERT_TRUE(until([&] { return (exclude = window->findChild<QPushButton*>("couplings.exclude")) != nullptr; }));
  exclude->click();
  ASSERT_EQ(document.joint().exclusions.size(), 1u);
  ASSERT_TRUE(until([this] { return snapshot().model->joint.exclusions.size() == 1; }));
  action("undo")->trigger();
  EXPECT_TRUE(document.joint().exclusions.empty());
  EXPECT_TRUE(until([&] { return window->findChild<QPushButton*>("couplings.exclude") != nullptr; })) << "proposed again";
}

TEST_F(CouplingTools, regionsAreNamedSets) {
  selection.select("block");
  QTest::keyClick(window.get(), Qt::Key_C);
  QTest::mouseClick(window->view(), Qt::LeftButton, {}, pixel(0.002, 0.02));
  ASSERT_EQ(authoring().selected().size(), 1u);
  QTest::keyClick(window.get(), Qt::Key_Up, Qt::ControlModifier);
  const std::vector<int> grown = authoring().selected();
  EXPECT_GT(grown.size(), 4u);
  press("couplings.newRegion");
  auto* regions = child<QListWidget>("couplings.regions");
  ASSERT_EQ(regions->count(), 1);
  regions->item(0)->setText(QStringLiteral("Front"));
  EXPECT_EQ(document.joint().parts[1].regions[0].name, "Front");
  QTest::keyClick(window.get(), Qt::Key_I, Qt::ControlModifier);
  EXPECT_EQ(authoring().selected().size() + grown.size(), 192u);
  regions->setCurrentRow(0);
  EXPECT_EQ(authoring().selected(), grown) << "choosing the set selects it";
  press("couplings.removeRegion");
  EXPECT_TRUE(document.joint().parts[1].regions.empty());
}

TEST_F(CouplingTools, regionsAreUnitedTakenAwayAndShared) {
  selection.select("block");
  QTest::keyClick(window.get(), Qt::Key_C);
  const auto regionAt = [&](const QPoint& at) {
    QTest::mouseClick(window->view(), Qt::LeftButton, {}, at);
    QTest::keyClick(window.get(), Qt::Key_Up, Qt::ControlModifier);
    press("couplings.newRegion");
    return authoring().selected();
  };
  const std::vector<int> a = regionAt(pixel(-0.004, 0.02)), b = regionAt(pixel(0.004, 0.02));
  ASSERT_NE(a, b);
  auto* regions = child<QListWidget>("couplings.regions");
  auto* combine = child<QComboBox>("couplings.combine");
  ASSERT_EQ(regions->count(), 2);
  const auto choose = [&](int how, int row) {
    combine->setCurrentIndex(how);
    regions->setCurrentRow(-1);
    regions->setCurrentRow(row);
  };
  choose(0, 0);
  EXPECT_EQ(authoring().selected(), a);
  choose(1, 1);
  EXPECT_EQ(authoring().selected(), united(a, b));
  choose(2, 0);
  EXPECT_EQ(authoring().selected(), without(b, a));
  choose(0, 0);
  choose(3, 1);
  EXPECT_EQ(authoring().selected(), common(a, b));
  QTest::keyClick(window.get(), Qt::Key_Z, Qt::ControlModifier);
  EXPECT_EQ(authoring().selected(), a) << "each is a step";
}

TEST_F(CouplingTools, nearWithinALassoAndContactOfThePair) {
  selection.select("block");
  QTest::keyClick(window.get(), Qt::Key_E);
  child<QDoubleSpinBox>("couplings.within")->setValue(0.6);
  press("couplings.near");
  ASSERT_TRUE(until([this] { return authoring().selected().size() == 32; }));
  const std::vector<int> under = authoring().selected();
  const std::vector<int> drawn(under.begin(), under.begin() + 7);
  authoring().select(united(drawn, {0, 1, 2}), QStringLiteral("a lasso"));
  const std::vector<int> lasso = authoring().selected();
  child<QCheckBox>("couplings.inSelection")->click();
  press("couplings.near");
  ASSERT_TRUE(until([&] { return authoring().selected() == common(lasso, under); }));
  auto* contact = child<QCheckBox>("couplings.contact");
  ASSERT_TRUE(contact->isEnabled());
  EXPECT_TRUE(contact->isChecked());
  contact->click();
  ASSERT_EQ(document.joint().exclusions.size(), 1u);
  EXPECT_TRUE(until([this] { return snapshot().model->joint.exclusions.size() == 1; })) << "the run takes it up";
  action("undo")->trigger();
  EXPECT_TRUE(document.joint().exclusions.empty());
  EXPECT_TRUE(contact->isChecked()) << "the box follows";
}

TEST_F(CouplingTools, noTwoActionsOfTheWindowShareAKey) {
  std::map<QString, QString> owner;
  for (const QAction* each : window->findChildren<QAction*>())
    for (const QKeySequence& key : each->shortcuts()) {
      const auto [it, isNew] = owner.try_emplace(key.toString(), each->objectName());
      EXPECT_TRUE(isNew || it->second == each->objectName())
          << key.toString().toStdString() << ": " << it->second.toStdString() << " and " << each->objectName().toStdString();
    }
  EXPECT_GT(owner.size(), 20u);
}

TEST_F(CouplingTools, boxLassoThroughAndEscape) {
  selection.select("block");
  QTest::keyClick(window.get(), Qt::Key_B);
  paint({pixel(-0.025, 0.045), pixel(0, 0.02), pixel(0.025, -0.003)});
  const std::size_t seen = authoring().selected().size();
  EXPECT_GE(seen, 32u) << "the front";
  paint({pixel(-0.025, 0.045), pixel(0, 0.02), pixel(0.025, -0.003)}, Qt::AltModifier);
  EXPECT_GT(authoring().selected().size(), seen) << "Alt goes through";
  QTest::keyClick(window.get(), Qt::Key_L);
  paint({pixel(-0.012, 0.01), pixel(0.012, 0.01), pixel(0.012, 0.03), pixel(-0.012, 0.03)});
  const std::size_t lasso = authoring().selected().size();
  EXPECT_GT(lasso, 0u);
  EXPECT_LT(lasso, seen);
  const double radius = authoring().radius();
  QTest::keyClick(window.get(), Qt::Key_BracketRight);
  EXPECT_GT(authoring().radius(), radius);
  QTest::keyClick(window.get(), Qt::Key_BracketLeft);
  EXPECT_NEAR(authoring().radius(), radius, 1e-9);
  QTest::mousePress(window->view(), Qt::LeftButton, {}, pixel(0, 0.02));
  EXPECT_TRUE(authoring().busy());
  QTest::keyClick(window->view(), Qt::Key_Escape);
  EXPECT_FALSE(authoring().busy());
  QTest::mouseRelease(window->view(), Qt::LeftButton, {}, pixel(0, 0.02));
  EXPECT_EQ(authoring().selected().size(), lasso) << "a cancelled stroke changes nothing";
  QTest::keyClick(window->view(), Qt::Key_Escape);
  EXPECT_FALSE(authoring().active());
  EXPECT_EQ(selection.current(), "block") << "the parts' selection stays";
}

}  // namespace
}  // namespace glenoid
