// SPDX-License-Identifier: GPL-3.0-or-later
// What the properties panel says of a part and changes in it.
#include <QComboBox>
#include <QDoubleSpinBox>
#include <QPushButton>

#include "tests/editor/ui/GuiTest.h"

namespace glenoid {
namespace {

class PartFieldsWindow : public GuiTest {
 protected:
  const Part& part(const char* id) const { return document.joint().parts[findPart(document.joint(), id)]; }
  bool runsAsCells() const {
    for (const SceneObject& object : snapshot().model->objects)
      if (object.id == "block") return object.cells;
    return false;
  }
};

TEST_F(PartFieldsWindow, elementsOfASoftPartAreChosenWithUndoAndTheRunTakesThemUp) {
  selection.select("plate");
  EXPECT_EQ(window->findChild<QComboBox*>(QStringLiteral("elements")), nullptr) << "it is rigid";
  selection.select("block");
  auto* box = child<QComboBox>("elements");
  ASSERT_TRUE(box);
  EXPECT_EQ(box->currentText(), QStringLiteral("tetrahedra"));
  EXPECT_FALSE(runsAsCells());
  box->setFocus();
  QTest::keyClick(box, Qt::Key_Down);
  EXPECT_EQ(part("block").elements, Elements::Cells);
  ASSERT_TRUE(until([this] { return runsAsCells(); })) << "the run goes on with cells";
  EXPECT_EQ(document.undoStack().count(), 1);
  action("undo")->trigger();
  EXPECT_EQ(part("block").elements, Elements::Tetrahedra);
  ASSERT_TRUE(until([this] { return !runsAsCells(); }));
  EXPECT_EQ(child<QComboBox>("elements")->currentText(), QStringLiteral("tetrahedra")) << "the field follows";
}

TEST_F(PartFieldsWindow, aPartIsPutElsewhereByNumbers) {
  selection.select("plate");
  const Box3 before = boundsOf(*part("plate").visual);
  child<QDoubleSpinBox>("place.shift.y")->setValue(-3);
  child<QPushButton>("place.apply")->click();
  EXPECT_NEAR((boundsOf(*part("plate").visual).center() - before.center()).y(), -0.003, 1e-12);
  EXPECT_EQ(document.undoStack().count(), 1);
  EXPECT_TRUE(until([this] { return child<QDoubleSpinBox>("place.shift.y")->value() == 0; })) << "the next move begins anew";
  action("undo")->trigger();
  EXPECT_EQ(boundsOf(*part("plate").visual).center(), before.center());
}

}  // namespace
}  // namespace glenoid
