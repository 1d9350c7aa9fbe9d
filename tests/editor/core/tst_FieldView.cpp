// SPDX-License-Identifier: GPL-3.0-or-later
// What the window shows of what parts bear, without a window: the real step on a block that stands on a plate.
#include "editor/core/FieldView.h"

#include <gtest/gtest.h>

#include "editor/core/FieldText.h"
#include "tests/editor/core/EventLoop.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

/// With its no-break spaces as plain ones.
QString plain(QString words) { return words.replace(QChar(0xa0), QLatin1Char(' ')); }

TEST(FieldText, numbersHaveThreeDigitsAndTheUnitOfTheirScale) {
  const QLocale c = QLocale::c();
  EXPECT_EQ(plain(fieldValue(23412, fieldUnit(Quantity::Stress, 30000), c)), QStringLiteral("23.4 kPa"));
  EXPECT_EQ(plain(fieldValue(-4, fieldUnit(Quantity::Pressure, 500), c)), QStringLiteral("−4.00 Pa"));
  EXPECT_EQ(plain(fieldValue(2.5e6, fieldUnit(Quantity::Stress, 3e6), c)), QStringLiteral("2.50 MPa"));
  EXPECT_EQ(plain(fieldValue(0.1234, fieldUnit(Quantity::Strain, 0.2), c)), QStringLiteral("12.3 %"));
  EXPECT_EQ(plain(fieldValue(0, fieldUnit(Quantity::Contact, 1e3), c)), QStringLiteral("0 kPa"));
  EXPECT_EQ(fieldUnit(Quantity::Stress, 999).word, QStringLiteral("Pa"));
  EXPECT_EQ(fieldUnit(Quantity::Stress, 1000).word, QStringLiteral("kPa"));
  EXPECT_EQ(plain(fieldReading(Quantity::Stress, QStringLiteral("Supraspinatus"), 23412, fieldUnit(Quantity::Stress, 30000))),
            QStringLiteral("Supraspinatus: 23.4 kPa von Mises stress"));
}

TEST(FieldText, theScaleSaysWhatLiesBeyondItsEnds) {
  auto values = std::make_shared<SurfaceValues>(SurfaceValues{{-150, 20, 70}, {}});
  const FieldLook look = fieldLook(Quantity::Pressure, values, {-100, 100}, QLocale::c());
  EXPECT_EQ(look.title, "Pressure in tissue (Pa)");
  ASSERT_EQ(look.ticks.size(), 5u);
  EXPECT_EQ(look.ticks.front().text, "≤ −100");
  EXPECT_EQ(look.ticks[2].text, "0");
  EXPECT_EQ(look.ticks.back().text, "100");
  EXPECT_EQ(mapOf(look), ColorMap::Diverging);
  const FieldLook contact = fieldLook(Quantity::Contact, values, {0, 0.05e6}, QLocale::c());
  EXPECT_TRUE(contact.zeroIsNone);
  EXPECT_EQ(contact.title, "Contact force per area (kPa)");
  EXPECT_EQ(contact.ticks.back().text, "50");
  EXPECT_EQ(fieldLook(Quantity::Strain, values, {0, 0.015}, QLocale::c()).ticks.back().text, "≥ 1.50");
  EXPECT_EQ(colorOf(contact, 0), kNeutralColor);
  for (int i = 0; i < 3; ++i) EXPECT_NEAR(colorOf(look, 0)[i], colorTable(ColorMap::Diverging)[128][i], 0.02) << "zero is the middle";
}

class FieldViewTest : public EventLoopTest {
 protected:
  void SetUp() override {
    document.open({scenes::blockOnPlateJoint(), scenes::blockOnPlateScenario(), nullptr}, {});
    ASSERT_TRUE(until([this] { return link.snapshot().model != nullptr; }));
  }
  bool shown() {
    return until([this] { return field.look({}).has_value(); });
  }
  /// A hit in the middle of a triangle of the block.
  PickHit hitOn(int object, int triangle) {
    const auto& visual = link.snapshot().model->objects[object].visual;
    std::vector<Vec3> at(visual.vertices.size());
    surfacePositions(visual, link.snapshot().model->objects[object].layout, link.snapshot().q, at);
    PickHit hit;
    hit.object = object;
    hit.triangle = triangle;
    hit.point_W.setZero();
    for (const int v : visual.mesh->triangles[triangle]) hit.point_W += at[v] / 3;
    return hit;
  }

  Document document;
  PlayLink link{document};
  FieldView field{link};
};

TEST_F(FieldViewTest, nothingIsCopiedOrComputedWhileNothingIsChosen) {
  link.play();
  ASSERT_TRUE(until([this] { return link.snapshot().step > 5; }));
  EXPECT_EQ(link.snapshot().rotations.size(), 0);
  EXPECT_FALSE(field.look({}));
  EXPECT_FALSE(field.placeOf(hitOn(1, 0)));
  field.show(Quantity::Contact);  // needs none either
  ASSERT_TRUE(shown());
  EXPECT_EQ(link.snapshot().rotations.size(), 0);
}

TEST_F(FieldViewTest, valuesAreThoseOfTheSnapshotThatIsShown) {
  field.show(Quantity::Stress);
  ASSERT_TRUE(shown());
  link.play();
  ASSERT_TRUE(until([this] { return link.snapshot().step > 100; }));
  link.pause();
  ASSERT_TRUE(until([this] { return !link.snapshot().playing; }));
  const Snapshot& snapshot = link.snapshot();
  State state;
  state.q = snapshot.q;
  state.rotations = snapshot.rotations;
  const SurfaceValues wanted = SurfaceField(snapshot.model).read(Quantity::Stress, state, {});
  const auto look = field.look({});
  ASSERT_TRUE(look);
  EXPECT_EQ(*look->values, wanted);
  EXPECT_EQ(look->values, field.look({})->values) << "once for a snapshot";
  const int block = findPart(snapshot.model->joint, "block"), plate = findPart(snapshot.model->joint, "plate");
  const auto& t = snapshot.model->objects[block].visual.mesh->triangles[3];
  const auto place = field.placeOf(hitOn(block, 3));
  ASSERT_TRUE(place);
  EXPECT_NEAR(*field.valueAt(*place), (wanted[block][t[0]] + wanted[block][t[1]] + wanted[block][t[2]]) / 3, 1e-3 * field.range().high);
  EXPECT_TRUE(field.readingAt(*place).startsWith(QStringLiteral("block: ")));
  const auto rigid = field.placeOf(hitOn(plate, 0));
  ASSERT_TRUE(rigid);
  EXPECT_FALSE(field.valueAt(*rigid));
  EXPECT_FALSE(field.readingAt(*rigid).isEmpty());
  PickHit beside;
  EXPECT_FALSE(field.placeOf(beside));
  beside = hitOn(block, 3);
  beside.surface = SurfaceKind::Collision;
  EXPECT_FALSE(field.placeOf(beside));
  link.reset();
  ASSERT_TRUE(until([&] { return link.snapshot().q != state.q; }));
  EXPECT_NE(*field.look({})->values, wanted);
}

TEST_F(FieldViewTest, whatIsHiddenHasNoSayInTheScale) {
  field.show(Quantity::Contact);
  link.play();
  ASSERT_TRUE(until([this] { return link.snapshot().report.pressing > 0; }));
  link.pause();
  ASSERT_TRUE(until([this] { return !link.snapshot().playing; }));
  ASSERT_TRUE(shown());
  EXPECT_NE(field.range(), rangeFor(Quantity::Contact, 0));
  Layers none;
  none.objects.resize(link.snapshot().model->objects.size());
  for (ObjectLook& look : none.objects) look.visible = false;
  field.look(none);
  EXPECT_EQ(field.range(), rangeFor(Quantity::Contact, 0));
}

TEST_F(FieldViewTest, aPlaceOfAnotherModelReadsNothing) {
  field.show(Quantity::Strain);
  ASSERT_TRUE(shown());
  const auto place = field.placeOf(hitOn(findPart(link.snapshot().model->joint, "block"), 0));
  ASSERT_TRUE(place);
  EXPECT_TRUE(field.valueAt(*place));
  const auto before = link.snapshot().model;
  document.setProfile(Profile::Reference);
  ASSERT_TRUE(until([&] { return link.snapshot().model != before; }));
  ASSERT_TRUE(shown());
  EXPECT_FALSE(field.valueAt(*place));
  EXPECT_TRUE(field.readingAt(*place).isEmpty());
}

}  // namespace
}  // namespace glenoid
