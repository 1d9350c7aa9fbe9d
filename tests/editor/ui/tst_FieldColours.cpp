// SPDX-License-Identifier: GPL-3.0-or-later
// Colours of what parts bear in the window: chosen, put on a scale, read under the mouse, switched off again.
#include <QCheckBox>
#include <QComboBox>
#include <QDoubleSpinBox>

#include "editor/core/FieldText.h"
#include "tests/editor/ui/GuiTest.h"

namespace glenoid {
namespace {

class FieldColours : public GuiTest {
 protected:
  /// The block stands on the plate, and the run is held.
  void stand() {
    link.play();
    ASSERT_TRUE(until([this] { return snapshot().step > 150; }));
    link.pause();
    ASSERT_TRUE(until([this] { return !snapshot().playing; }));
    settle();
  }
  FieldView& field() { return window->field(); }
  bool coloured() {
    return until([this] {
      QTest::qWait(20);
      return field().look(Layers{}).has_value();
    });
  }
  QLabel* reading() { return child<QLabel>("fieldReading"); }
  void pointAt(const Vec3& p_W) {
    const auto at = window->view()->toScreen(p_W);
    ASSERT_TRUE(at);
    QTest::qWait(150);  // the mouse is looked at every so often
    QTest::mouseMove(window->view(), at->toPoint() - QPoint(1, 1));
    QTest::qWait(150);
    QTest::mouseMove(window->view(), at->toPoint());
    settle();
  }
};

TEST_F(FieldColours, aChosenQuantityColoursThePartsAndOffBringsTheirLooksBack) {
  stand();
  const QImage plain = grabView();
  EXPECT_EQ(snapshot().rotations.size(), 0) << "nothing is copied while nothing is chosen";
  EXPECT_TRUE(action("colour.off")->isChecked());
  for (const char* name : {"stress", "strain", "pressure", "contact"}) {
    action((std::string("colour.") + name).c_str())->trigger();
    ASSERT_TRUE(coloured()) << name;
    settle();
    EXPECT_GT(difference(plain, grabView()), 0.03) << name;
    EXPECT_EQ(child<QComboBox>("field.quantity")->currentIndex(), 1 + static_cast<int>(*quantityNamed(name)));
    EXPECT_TRUE(action((std::string("colour.") + name).c_str())->isChecked());
    EXPECT_FALSE(action("colour.off")->isChecked());
  }
  action("colour.off")->trigger();
  settle();
  EXPECT_LT(difference(plain, grabView()), 1e-4);
  EXPECT_TRUE(until([this] { return snapshot().rotations.size() == 0; }));
  EXPECT_TRUE(document.undoStack().isClean()) << "looking is no edit";
  EXPECT_EQ(document.undoStack().count(), 0);
}

TEST_F(FieldColours, theKeyGoesThroughAllAndBack) {
  for (const Quantity quantity : kQuantities) {
    QTest::keyClick(window.get(), Qt::Key_V);
    EXPECT_EQ(field().quantity(), quantity);
  }
  QTest::keyClick(window.get(), Qt::Key_V);
  EXPECT_FALSE(field().quantity());
}

TEST_F(FieldColours, aScaleByHandStaysAndTheAutomaticOneComesBack) {
  stand();
  auto* quantity = child<QComboBox>("field.quantity");
  EXPECT_FALSE(child<QDoubleSpinBox>("field.high")->isEnabled());
  quantity->setCurrentIndex(1);
  emit quantity->activated(1);
  ASSERT_TRUE(coloured());
  settle();
  const QImage automatic = grabView();
  const FieldRange own = field().range();
  auto* high = child<QDoubleSpinBox>("field.high");
  ASSERT_TRUE(until([&] { return high->isEnabled() && high->value() > 0; }));
  EXPECT_NE(child<QLabel>("field.unit")->text().indexOf(QStringLiteral("Pa")), -1);
  high->setValue(10 * high->value());
  settle();
  EXPECT_FALSE(field().isAutomatic());
  EXPECT_NEAR(field().range().high, 10 * own.high, 1e-6 * own.high);
  EXPECT_GT(difference(automatic, grabView()), 0.01);
  link.stepOnce();
  settle();
  EXPECT_NEAR(field().range().high, 10 * own.high, 1e-6 * own.high) << "it stays";
  child<QCheckBox>("field.automatic")->click();
  settle();
  EXPECT_EQ(field().range(), own);
  // Ends the wrong way round are moved apart, and nothing breaks.
  field().setRange({5, 5});
  EXPECT_GT(field().range().high, field().range().low);
}

TEST_F(FieldColours, theMouseReadsTheValueOfWhatItPointsAt) {
  stand();
  pointAt(Vec3(0, 0.02, 0.02));
  EXPECT_FALSE(reading()->isVisible()) << "nothing is chosen";
  field().show(Quantity::Stress);
  ASSERT_TRUE(coloured());
  pointAt(Vec3(0, 0.02, 0.02));  // the block's front
  ASSERT_TRUE(until([this] { return reading()->isVisible(); }));
  const QString words = reading()->text();
  EXPECT_TRUE(words.startsWith(QStringLiteral("block: "))) << words.toStdString();
  EXPECT_TRUE(words.endsWith(QStringLiteral("Pa von Mises stress"))) << words.toStdString();
  // The number is that of the field in the middle of the block's front.
  State state;
  state.q = snapshot().q;
  state.rotations = snapshot().rotations;
  const auto model = snapshot().model;
  const int block = findPart(model->joint, "block");
  const SurfaceValues values = SurfaceField(model).read(Quantity::Stress, state, {});
  float least = 1e30f, most = 0;
  const auto& vertices = model->joint.parts[block].visual->vertices;
  for (std::size_t v = 0; v < vertices.size(); ++v)
    if (std::abs(vertices[v].z() - 0.02) < 1e-6 && std::hypot(vertices[v].x(), vertices[v].y() - 0.02) < 0.015)
      least = std::min(least, values[block][v]), most = std::max(most, values[block][v]);
  const FieldUnit unit = fieldUnit(Quantity::Stress, field().range().high);
  const double read = QLocale().toDouble(words.mid(7, words.indexOf(QChar(0xa0)) - 7)) * unit.si;
  EXPECT_GE(read, least - 0.01 * most);
  EXPECT_LE(read, 1.01 * most);
  pointAt(Vec3(0.03, -0.004, 0.05));  // the plate is rigid
  EXPECT_TRUE(reading()->isVisible());
  EXPECT_EQ(reading()->text(), QStringLiteral("plate: rigid, so nothing to read inside"));
  // What the mouse rests on is read anew after a step.
  pointAt(Vec3(0, 0.02, 0.02));
  field().show(Quantity::Pressure);
  ASSERT_TRUE(coloured());
  settle();
  EXPECT_TRUE(reading()->text().endsWith(QStringLiteral("pressure in tissue"))) << reading()->text().toStdString();
  field().show(std::nullopt);
  settle();
  EXPECT_FALSE(reading()->isVisible());
}

TEST_F(FieldColours, wordsFollowTheLanguage) {
  setLanguage(QStringLiteral("es"));
  QCoreApplication::processEvents();
  EXPECT_EQ(action("colour.stress")->text(), QStringLiteral("Tensión"));
  EXPECT_EQ(child<QComboBox>("field.quantity")->itemText(0), QStringLiteral("No"));
}

TEST_F(FieldColours, anotherModelIsColouredTooAndARunGoesOn) {
  field().show(Quantity::Stress);
  ASSERT_TRUE(coloured());
  document.setProfile(Profile::Reference);
  const auto before = snapshot().model;
  ASSERT_TRUE(until([&] { return snapshot().model != before; }));
  ASSERT_TRUE(coloured());
  link.play();
  ASSERT_TRUE(until([this] { return snapshot().step > 20; }));
  EXPECT_TRUE(coloured());
  window->openScene(QStringLiteral("block"));
  ASSERT_TRUE(until([this] { return snapshot().step == 0; }));
  EXPECT_TRUE(coloured());
}

}  // namespace
}  // namespace glenoid
