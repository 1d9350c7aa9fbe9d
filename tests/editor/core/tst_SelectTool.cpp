// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/tools/SelectTool.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

/// A box of 40 mm, 4 × 4 squares a side, seen straight from the front: its face z = 20 mm fills the middle.
struct Front {
  Front() {
    viewport.view.eye_W = Vec3(0, 0, 0.3);
    viewport.view.target_W = Vec3::Zero();
    viewport.view.fieldOfView = 0.4;
    viewport.width = 800;
    viewport.height = 600;
    tool.setTarget(box, {});
  }
  Pointer at(double x, double y, double z = 0.02) const {
    return {*projected(viewport.view, Vec3(x, y, z), viewport.width, viewport.height)};
  }
  std::vector<int> where(const std::function<bool(const Vec3&)>& holds) const {
    std::vector<int> list;
    for (int t = 0; t < static_cast<int>(box->triangles.size()); ++t) {
      Vec3 sum = Vec3::Zero();
      for (const int v : box->triangles[t]) sum += box->vertices[v] / 3;
      if (holds(sum)) list.push_back(t);
    }
    return list;
  }
  std::vector<int> drag(Pointer from, Pointer to, const std::vector<int>& selected = {}) {
    to.shift = from.shift, to.ctrl = from.ctrl, to.alt = from.alt;
    tool.press(viewport, from, selected);
    Pointer middle = from;
    middle.at = (from.at + to.at) / 2;
    tool.move(middle);
    tool.move(to);
    return tool.release(to);
  }
  std::shared_ptr<const TriMesh> box =
      std::make_shared<TriMesh>(scenes::boxSurface(Vec3(-0.02, -0.02, -0.02), Vec3(0.02, 0.02, 0.02), 4));
  Viewport viewport;
  SelectTool tool;
};

TEST(SelectTool, aBoxTakesTheFrontAndAltTheBackAsWell) {
  Front front;
  front.tool.setMode(PickMode::Box);
  const Pointer a = front.at(-0.025, 0.025), b = front.at(0, -0.025);
  EXPECT_EQ(front.drag(a, b), front.where([](const Vec3& p) { return p.z() > 0.0199 && p.x() < 0; }));
  Pointer through = a;
  through.alt = true;
  const std::vector<int> all = front.drag(through, b);
  const std::vector<int> back = front.where([](const Vec3& p) { return p.z() < -0.0199 && p.x() < -1e-3; });
  EXPECT_TRUE(std::includes(all.begin(), all.end(), back.begin(), back.end()));
  EXPECT_GT(all.size(), 32u) << "front, back and the side that is turned away";
}

TEST(SelectTool, shiftAddsCtrlSubtractsNeitherBeginsAnew) {
  Front front;
  front.tool.setMode(PickMode::Box);
  const std::vector<int> left = front.drag(front.at(-0.02, 0.02), front.at(0, -0.02));
  Pointer more = front.at(0.001, 0.02);
  more.shift = true;
  const std::vector<int> both = front.drag(more, front.at(0.02, -0.02), left);
  EXPECT_EQ(both, front.where([](const Vec3& p) { return p.z() > 0.0199; }));
  Pointer less = front.at(-0.02, 0.02);
  less.ctrl = true;
  EXPECT_EQ(front.drag(less, front.at(0, -0.02), both), front.where([](const Vec3& p) { return p.z() > 0.0199 && p.x() > 0; }));
  EXPECT_EQ(front.drag(front.at(-0.02, 0.02), front.at(0, -0.02), both), left);
}

TEST(SelectTool, aClickTakesOneTriangleAndBesideItNone) {
  Front front;
  front.tool.setMode(PickMode::Click);
  const Pointer at = front.at(0.004, 0.007);
  front.tool.press(front.viewport, at, {});
  const std::vector<int> one = front.tool.release(at);
  ASSERT_EQ(one.size(), 1u);
  const Pointer beside = front.at(0.05, 0.05);
  front.tool.press(front.viewport, beside, one);
  EXPECT_TRUE(front.tool.release(beside).empty());
}

TEST(SelectTool, aLassoTakesWhatItGoesAround) {
  Front front;
  front.tool.setMode(PickMode::Lasso);
  const Vec2 middle = front.at(0.01, 0.01).at;
  std::vector<Vec2> way = circleOutline(middle, (front.at(0.021, 0.01).at - middle).norm());
  front.tool.press(front.viewport, {way.front()}, {});
  for (const Vec2& p : way) front.tool.move({p});
  const std::vector<int> taken = front.tool.release({way.back()});
  EXPECT_EQ(taken, front.where([](const Vec3& p) {
              return p.z() > 0.0199 && (p.head<2>() - Vec2(0.01, 0.01)).norm() < 0.011;
            }));
  EXPECT_GT(taken.size(), 4u);
}

TEST(SelectTool, aBrushPaintsItsWayAlsoWithAFewEvents) {
  Front front;
  front.tool.setMode(PickMode::Brush);
  front.tool.setRadius(4);  // far smaller than a triangle, whose centres it misses
  const std::vector<int> painted = front.drag(front.at(-0.019, 0.0043), front.at(0.019, 0.0043));
  const std::vector<int> row = front.where([](const Vec3& p) { return p.z() > 0.0199 && p.y() > 0 && p.y() < 0.01; });
  EXPECT_EQ(painted, row) << "both triangles of the row's four squares";
  Pointer rub = front.at(-0.019, 0.0043);
  rub.ctrl = true;
  EXPECT_TRUE(front.drag(rub, front.at(0.019, 0.0043), painted).empty());
}

TEST(SelectTool, cancelEndsAStroke) {
  Front front;
  front.tool.press(front.viewport, front.at(0, 0), {});
  EXPECT_TRUE(front.tool.busy());
  front.tool.cancel();
  EXPECT_FALSE(front.tool.busy());
  EXPECT_TRUE(front.tool.release(front.at(0, 0)).empty());
  SelectTool without;
  without.press(front.viewport, front.at(0, 0), {});
  EXPECT_FALSE(without.busy()) << "nothing to pick from";
}

}  // namespace
}  // namespace glenoid
