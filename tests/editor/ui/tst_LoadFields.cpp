// SPDX-License-Identifier: GPL-3.0-or-later
// Loads, the time in which they rise, and whether the run is at rest, in the properties panel.
#include <QDoubleSpinBox>
#include <QPushButton>

#include "tests/editor/ui/GuiTest.h"

namespace glenoid {
namespace {

class LoadFieldsWindow : public GuiTest {
 protected:
  Result<Scene> load(const std::string&) override {
    Scene scene = blockScene();
    scene.scenario.loads = {{"block", Vec3(0.125, -0.5, 0), Vec3::Zero(), Vec3(0.0012345, 0.02, 0)}, {"block", Vec3(0, -0.25, 0)}};
    scene.scenario.loadRise = 0.1;
    return scene;
  }
  const std::vector<Load>& loads() const { return document.scenario().loads; }
  QDoubleSpinBox* box(const char* name) { return child<QDoubleSpinBox>(name); }
  void type(const char* name, const char* digits) {
    QDoubleSpinBox* field = box(name);
    ASSERT_TRUE(field);
    field->setFocus();
    field->selectAll();
    QTest::keyClicks(field, QString::fromLatin1(digits));
    QTest::keyClick(field, Qt::Key_Return);
  }
};

TEST_F(LoadFieldsWindow, theSceneShowsAllLoadsAndTheyAreEditedWithUndo) {
  EXPECT_DOUBLE_EQ(box("loadRise")->value(), 0.1);
  EXPECT_DOUBLE_EQ(box("load.0.force.x")->value(), 0.125);
  EXPECT_DOUBLE_EQ(box("load.1.force.y")->value(), -0.25);
  EXPECT_DOUBLE_EQ(box("load.0.point.x")->value(), 1.23) << "mm";
  EXPECT_TRUE(child<QLabel>("load.0.title")->text().contains(QString::fromStdString(document.joint().parts[findPart(document.joint(), "block")].name)));
  EXPECT_TRUE(child<QLabel>("load.1.where")->text().contains(QStringLiteral("weight")));
  EXPECT_EQ(window->findChild<QDoubleSpinBox*>(QStringLiteral("load.0.torque.x")), nullptr) << "tissue takes none";
  type("load.0.force.z", "1.5");
  type("load.0.point.y", "21.5");
  type("loadRise", "0.25");
  EXPECT_EQ(loads()[0].force_W, Vec3(0.125, -0.5, 1.5));
  EXPECT_DOUBLE_EQ(loads()[0].point_W->y(), 0.0215);
  EXPECT_EQ(loads()[0].point_W->x(), 0.0012345) << "what was not edited keeps every digit";
  EXPECT_EQ(document.scenario().loadRise, 0.25);
  EXPECT_EQ(document.undoStack().count(), 3);
  ASSERT_TRUE(until([this] { return snapshot().model && snapshot().model->scenario.loadRise == 0.25; })) << "the run takes it up";
  for (int i = 0; i < 3; ++i) action("undo")->trigger();
  EXPECT_EQ(document.scenario().loadRise, 0.1);
  EXPECT_EQ(loads()[0].force_W.z(), 0);
  EXPECT_DOUBLE_EQ(box("loadRise")->value(), 0.1) << "the fields follow";
  EXPECT_DOUBLE_EQ(box("load.0.force.z")->value(), 0);
  type("load.0.force.z", "9999999");
  EXPECT_LE(std::abs(loads()[0].force_W.z()), 1e6);
}

TEST_F(LoadFieldsWindow, aPartShowsItsOwnAndTakesMore) {
  selection.select("plate");
  EXPECT_EQ(window->findChild<QPushButton*>(QStringLiteral("addLoad")), nullptr) << "it is fixed";
  selection.select("block");
  QTest::mouseClick(child<QPushButton>("addLoad"), Qt::LeftButton);
  ASSERT_TRUE(until([this] { return loads().size() == 3; }));
  EXPECT_EQ(loads()[2].part, "block");
  EXPECT_DOUBLE_EQ(box("load.2.force.y")->value(), -1);
  QTest::mouseClick(child<QPushButton>("load.0.remove"), Qt::LeftButton);
  ASSERT_TRUE(until([this] { return loads().size() == 2; }));
  EXPECT_FALSE(loads()[0].point_W);
  action("undo")->trigger();
  action("undo")->trigger();
  EXPECT_EQ(loads().size(), 2u);
  EXPECT_TRUE(loads()[0].point_W);
  for (QPushButton* button : window->findChildren<QPushButton*>(QRegularExpression(QStringLiteral("^load\\."))))
    EXPECT_FALSE(button->accessibleName().isEmpty());
}

TEST_F(LoadFieldsWindow, theSceneSaysWhetherItIsAtRest) {
  const auto state = [this] { return child<QLabel>("restState")->text(); };  // edits make another label
  EXPECT_EQ(state(), QStringLiteral("not run yet"));
  type("load.0.force.x", "0");  // sideways it would slide away
  ASSERT_TRUE(until([this] { return snapshot().model->scenario.loads[0].force_W.x() == 0; }));
  link.stepOnce();
  ASSERT_TRUE(until([&] { return state() == QStringLiteral("loads are rising"); })) << state().toStdString();
  for (int i = 0; i < 20; ++i) link.stepOnce();
  ASSERT_TRUE(until([this] { return snapshot().step == 21; }));
  link.play();
  EXPECT_TRUE(until([&] { return state() == QStringLiteral("at rest"); })) << state().toStdString();
  document.setYoungsModulus("tissue", 4e3);  // it sags
  EXPECT_TRUE(until([&] { return state().startsWith(QStringLiteral("moving at up to")); })) << state().toStdString();
}

}  // namespace
}  // namespace glenoid
