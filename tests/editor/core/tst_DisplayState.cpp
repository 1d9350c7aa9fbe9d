// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/DisplayState.h"

#include <gtest/gtest.h>

namespace glenoid {
namespace {

Model threeObjects() {
  Model model;
  for (const char* id : {"a", "b", "c"}) {
    SceneObject object;
    object.id = id;
    model.objects.push_back(object);
  }
  return model;
}

TEST(DisplayState, everyLayerCanBeSwitchedAndSaysSoOnce) {
  DisplayState display;
  int said = 0;
  QObject::connect(&display, &DisplayState::changed, [&said] { ++said; });
  int expected = 0;
  for (const DisplayState::Layer layer : DisplayState::kLayers) {
    const bool before = display.isShown(layer);
    display.show(layer, before);
    EXPECT_EQ(said, expected) << "nothing changed";
    display.show(layer, !before);
    EXPECT_EQ(said, ++expected);
    EXPECT_EQ(display.isShown(layer), !before);
    for (const DisplayState::Layer other : DisplayState::kLayers) {
      if (other == layer) continue;
      EXPECT_EQ(display.isShown(other), DisplayState().isShown(other));
    }
    display.show(layer, before);
    ++expected;
  }
}

TEST(DisplayState, islandsHaveTheirColours) {
  Model model = threeObjects();
  model.couplingIslandOfObject = {0, -1, 1};
  DisplayState display;
  Selection selection;
  EXPECT_FALSE(display.layersFor(model, selection).objects[0].color);
  display.show(DisplayState::Layer::Islands, true);
  const auto objects = display.layersFor(model, selection).objects;
  ASSERT_TRUE(objects[0].color && objects[2].color);
  EXPECT_FALSE(objects[1].color) << "fixed: its own colour";
  for (int a = 0; a < 12; ++a)
    for (int b = 0; b < a; ++b) {
      const auto p = DisplayState::islandColor(a), q = DisplayState::islandColor(b);
      EXPECT_GT(std::abs(p[0] - q[0]) + std::abs(p[1] - q[1]) + std::abs(p[2] - q[2]), 0.08f) << a << " and " << b;
    }
}

TEST(DisplayState, looksGoToTheRendererByObject) {
  DisplayState display;
  Selection selection;
  display.setVisible("b", false);
  display.setOpacity("c", 0.25);
  selection.select("a");
  selection.hover("c");
  const Layers layers = display.layersFor(threeObjects(), selection);
  ASSERT_EQ(layers.objects.size(), 3u);
  EXPECT_TRUE(layers.objects[0].selected);
  EXPECT_FALSE(layers.objects[1].visible);
  EXPECT_EQ(layers.objects[2].opacity, 0.25f);
  EXPECT_TRUE(layers.objects[2].hovered);
}

TEST(DisplayState, soloHidesTheOthersAndGivesBackWhatWasThere) {
  DisplayState display;
  const Selection selection;
  display.setVisible("b", false);
  display.solo({"b"});
  Layers layers = display.layersFor(threeObjects(), selection);
  EXPECT_FALSE(layers.objects[0].visible);
  EXPECT_TRUE(layers.objects[1].visible);
  display.solo({});
  layers = display.layersFor(threeObjects(), selection);
  EXPECT_TRUE(layers.objects[0].visible);
  EXPECT_FALSE(layers.objects[1].visible);
  display.showAll();
  EXPECT_TRUE(display.layersFor(threeObjects(), selection).objects[1].visible);
}

TEST(DisplayState, opacityStaysInItsRange) {
  DisplayState display;
  display.setOpacity("a", 7);
  EXPECT_EQ(display.opacity("a"), 1);
  display.setOpacity("a", -1);
  EXPECT_EQ(display.opacity("a"), 0);
}

TEST(Selection, addRemoveAndCurrent) {
  Selection selection;
  selection.select("a");
  selection.add("b");
  EXPECT_EQ(selection.current(), "b");
  selection.remove("b");
  EXPECT_EQ(selection.ids(), std::set<std::string>{"a"});
  EXPECT_EQ(selection.current(), "a");
  selection.clear();
  EXPECT_TRUE(selection.current().empty());
}

}  // namespace
}  // namespace glenoid
