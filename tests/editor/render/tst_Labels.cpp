// SPDX-License-Identifier: GPL-3.0-or-later
// Names beside a picture: where they stand, what they look like, and that what is hidden is not named.
#include <random>

#include "editor/render/LabelLayout.h"
#include "editor/render/TextRaster.h"
#include "tests/editor/render/PictureCheck.h"
#include "tests/editor/render/TestScene.h"

namespace glenoid::test {
namespace {

struct Plate {
  double left, top, right, bottom;
};
Plate plateOf(const LabelPlace& place, const LabelWish& wish) {
  return {place.corner.x(), place.corner.y(), place.corner.x() + wish.width, place.corner.y() + wish.height};
}

TEST(LabelLayout, namesNeitherOverlapNorLeaveThePictureNorCrossLines) {
  std::mt19937 random(7);
  std::uniform_real_distribution<double> unit(0, 1);
  const LabelArea area{900, 700, 10, 4, 96};
  for (const int count : {1, 5, 20, 40}) {
    std::vector<LabelWish> wishes;
    for (int i = 0; i < count; ++i) wishes.push_back({{200 + 500 * unit(random), 700 * unit(random)}, 40 + 140 * unit(random), 20});
    const std::vector<LabelPlace> places = layOutLabels(wishes, area);
    ASSERT_EQ(places.size(), wishes.size());
    for (int i = 0; i < count; ++i) {
      ASSERT_TRUE(places[i].placed) << "forty names have room";
      const Plate a = plateOf(places[i], wishes[i]);
      const bool left = a.left < 450;
      EXPECT_GE(a.left, area.margin - 1e-9);
      EXPECT_LE(a.right, area.width - area.margin + 1e-9);
      EXPECT_GE(a.top, area.margin - 1e-9);
      EXPECT_LE(a.bottom, area.height - area.margin - (left ? area.taken : 0) + 1e-9);
      for (int j = 0; j < i; ++j) {
        const Plate b = plateOf(places[j], wishes[j]);
        EXPECT_TRUE(a.bottom <= b.top + 1e-9 || b.bottom <= a.top + 1e-9 || a.right <= b.left || b.right <= a.left);
        if (left != (b.left < 450)) continue;
        EXPECT_EQ(a.top < b.top, wishes[i].anchor.y() < wishes[j].anchor.y()) << "a column keeps the order of its anchors";
      }
    }
  }
}

TEST(LabelLayout, aNameStandsLevelWithItsAnchorWhereNothingPushesIt) {
  const std::vector<LabelPlace> places = layOutLabels({{{100, 300}, 80, 20}, {{800, 120}, 80, 20}}, {900, 700});
  EXPECT_DOUBLE_EQ(places[0].corner.x(), 10);
  EXPECT_DOUBLE_EQ(places[0].lineEnd.y(), 300);
  EXPECT_DOUBLE_EQ(places[1].lineEnd.y(), 120);
  EXPECT_DOUBLE_EQ(places[1].lineEnd.x(), 900 - 10 - 80);
}

TEST(LabelLayout, whatHasNoRoomIsLeftOut) {
  std::vector<LabelWish> wishes(50, {{100, 100}, 80, 20});
  wishes.push_back({{100, 100}, 2000, 20});
  const std::vector<LabelPlace> places = layOutLabels(wishes, {900, 300});
  int placed = 0;
  for (const LabelPlace& place : places) placed += place.placed;
  EXPECT_EQ(placed, 2 * (280 / 24));
  EXPECT_FALSE(places.back().placed) << "wider than the picture";
  for (const LabelPlace& place : layOutLabels(std::vector<LabelWish>(3, {{10, 10}, 30, 20}), {20, 10})) EXPECT_FALSE(place.placed);
}

TEST(TextRaster, drawsWhatIsWritten) {
  TextRaster raster;
  ASSERT_TRUE(raster.hasFont()) << "fonts-dejavu-core is among the packages";
  const auto ink = [](const TextPicture& picture) {
    long sum = 0;
    for (const std::uint8_t value : picture.ink) sum += value;
    return sum;
  };
  const TextPicture one = raster.line("i", 16), two = raster.line("ii", 16), wide = raster.line("W", 16);
  EXPECT_GT(ink(one), 0);
  EXPECT_NEAR(static_cast<double>(ink(two)), 2.0 * static_cast<double>(ink(one)), 0.1 * static_cast<double>(ink(two)));
  EXPECT_GT(wide.width, one.width);
  EXPECT_EQ(one.height, wide.height);
  EXPECT_GT(raster.line("i", 32).height, 1.8 * one.height);
  EXPECT_NE(raster.line("é", 16).ink, raster.line("e", 16).ink);
  EXPECT_EQ(ink(raster.line("", 16)), 0);
  for (const char* broken : {"\xff", "\xc3", "a\xe2\x82", "\xf8\x88\x80"}) EXPECT_GT(raster.line(broken, 16).width, 0);
}

class Labels : public Drawing {};

TEST_F(Labels, nameWhatIsSeenAndNothingElse) {
  const Model model = smallScene();
  ASSERT_TRUE(m_renderer->setScene(model).ok());
  Layers plain, named;
  named.labels = true;
  Look look;
  look.samples = 1;
  const View view = viewFrom(Side::Anterior, m_renderer->bounds(model.start.q, plain), 1.5);
  const auto draw = [&](const Layers& layers) { return m_renderer->picture(view, model.start.q, layers, {}, look, 480, 320).value(); };
  const Image without = draw(plain), with = draw(named);
  EXPECT_GT(compareImages(without, with).fractionDifferent, 0.002);
  // With everything hidden there is nothing to name.
  named.objects.assign(model.objects.size(), ObjectLook{});
  for (ObjectLook& object : named.objects) object.visible = false;
  plain.objects = named.objects;
  EXPECT_EQ(compareImages(draw(plain), draw(named)).fractionDifferent, 0);
  // Another name in place of the model's.
  Layers other;
  other.labels = true;
  for (const SceneObject& object : model.objects) other.names[object.name] = "Æ" + object.name;
  EXPECT_GT(compareImages(with, draw(other)).fractionDifferent, 0.0005);
}

}  // namespace
}  // namespace glenoid::test

int main(int argc, char** argv) {
  return glenoid::test::runPictureTests(argc, argv);
}
