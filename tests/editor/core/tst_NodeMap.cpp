// SPDX-License-Identifier: GPL-3.0-or-later
// Nodes picked on the screen: what is in sight, and by every way of picking.
#include "editor/core/tools/NodeMap.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "editor/core/tools/SelectTool.h"
#include "tests/scenes/NodeScenes.h"

namespace glenoid {
namespace {

/// Cells of 10 mm in a cube of 40 mm, seen from the front, from above and from the right, so that no two nodes share a pixel.
struct CellsInSight {
  CellsInSight() {
    viewport.view.eye_W = Vec3(0.06, 0.05, 0.3);
    viewport.view.target_W = Vec3::Zero();
    viewport.view.fieldOfView = 0.4;
    viewport.width = 800;
    viewport.height = 600;
    tool.setNodes(cells, {});
  }
  Vec2 pixel(const Vec3& p) const { return *projected(viewport.view, p, viewport.width, viewport.height); }
  std::vector<int> where(const std::function<bool(const Vec3&)>& holds) const {
    Part part;
    part.volume = cells;
    return scenes::nodesWhere(part, holds);
  }
  std::vector<int> drag(const Vec2& from, const Vec2& to, Pointer keys = {}, const std::vector<int>& selected = {}) {
    const auto at = [&keys](const Vec2& p) { return Pointer{p, keys.shift, keys.ctrl, keys.alt}; };
    tool.press(viewport, at(from), selected);
    tool.move(at((from + to) / 2));
    tool.move(at(to));
    return tool.release(at(to));
  }
  std::shared_ptr<const TetMesh> cells = std::make_shared<TetMesh>(scenes::boxVolume(Vec3(-0.02, -0.02, -0.02), Vec3(0.02, 0.02, 0.02), 4, 4, 4));
  Viewport viewport;
  SelectTool tool;
};

bool onSeenFace(const Vec3& p) { return p.z() > 0.0199 || p.x() > 0.0199 || p.y() > 0.0199; }

TEST(NodeMap, seesTheNodesOfTheFacesThatLookAtIt) {
  const CellsInSight scene;
  const NodeMap map(scene.viewport, *scene.cells, {});
  for (int i = 0; i < static_cast<int>(scene.cells->nodes.size()); ++i) {
    const Vec3& p = scene.cells->nodes[i];
    EXPECT_LT((map.centres()[i].cast<double>() - scene.pixel(p)).norm(), 0.01);
    EXPECT_EQ(map.seen(i), onSeenFace(p)) << p.transpose();
  }
}

TEST(NodeMap, othersHideAndUnusedNodesAreNowhere) {
  const CellsInSight scene;
  const auto wall = std::make_shared<const TriMesh>(scenes::boxSurface(Vec3(-0.05, -0.05, 0.05), Vec3(0, 0.05, 0.06), 1));
  const std::vector<std::shared_ptr<const TriMesh>> others{wall, nullptr};
  TetMesh cells = *scene.cells;
  cells.nodes.push_back(Vec3(0.01, 0.03, 0.02));
  const NodeMap map(scene.viewport, cells, others);
  int hidden = 0;
  for (int i = 0; i + 1 < static_cast<int>(cells.nodes.size()); ++i) {
    const Vec3& p = cells.nodes[i];
    if (!onSeenFace(p)) continue;
    // The way to the eye goes through the wall where x < 0 at its back.
    const double s = (0.05 - p.z()) / (0.3 - p.z()), x = p.x() + s * (0.06 - p.x());
    if (std::abs(x) < 1e-3) continue;
    EXPECT_EQ(map.seen(i), x > 0) << p.transpose();
    hidden += x < 0;
  }
  EXPECT_GT(hidden, 10);
  const int unused = static_cast<int>(cells.nodes.size()) - 1;
  EXPECT_FALSE(map.seen(unused));
  EXPECT_EQ(map.at(scene.pixel(cells.nodes[unused]), true), -1);
}

TEST(NodeMap, aClickTakesTheNearestInSight) {
  CellsInSight scene;
  scene.tool.setMode(PickMode::Click);
  const auto corner = scene.where([](const Vec3& p) { return (p - Vec3(0.01, -0.01, 0.02)).norm() < 1e-9; });
  const Vec2 at = scene.pixel(Vec3(0.01, -0.01, 0.02));
  EXPECT_EQ(scene.drag(at + Vec2(3, -4), at + Vec2(3, -4)), corner);
  EXPECT_TRUE(scene.drag(at + Vec2(9, -9), at + Vec2(9, -9)).empty()) << "too far from any";
  const auto back = scene.where([](const Vec3& p) { return (p - Vec3(-0.01, -0.01, -0.02)).norm() < 1e-9; });
  const Vec2 behind = scene.pixel(Vec3(-0.01, -0.01, -0.02));
  EXPECT_NE(scene.drag(behind, behind), back);
  Pointer through;
  through.alt = true;
  EXPECT_EQ(scene.drag(behind, behind, through), back);
}

TEST(NodeMap, boxesLassosAndBrushesAddAndTakeAway) {
  CellsInSight scene;
  scene.tool.setMode(PickMode::Box);
  const std::vector<int> seen = scene.drag(Vec2(0, 0), Vec2(800, 600));
  EXPECT_EQ(seen, scene.where(onSeenFace));
  Pointer keys;
  keys.alt = true;
  EXPECT_EQ(scene.drag(Vec2(0, 0), Vec2(800, 600), keys).size(), scene.cells->nodes.size());
  keys = {};
  keys.ctrl = true;
  // Take what lies right of the front's middle column away.
  const double middle = scene.pixel(Vec3(0.005, 0, 0.02)).x();
  const std::vector<int> left = scene.drag(Vec2(middle, 0), Vec2(800, 600), keys, seen);
  EXPECT_LT(left.size(), seen.size());
  for (const int node : left) EXPECT_LT(scene.pixel(scene.cells->nodes[node]).x(), middle);
  keys = {};
  keys.shift = true;
  EXPECT_EQ(scene.drag(Vec2(middle, 0), Vec2(800, 600), keys, left), seen);

  scene.tool.setMode(PickMode::Lasso);
  const Vec2 centre = scene.pixel(Vec3(-0.01, 0, 0.02));
  const double radius = (scene.pixel(Vec3(0.001, 0, 0.02)) - centre).norm();
  const std::vector<Vec2> way = circleOutline(centre, radius);
  scene.tool.press(scene.viewport, {way.front()}, {});
  for (const Vec2& p : way) scene.tool.move({p});
  std::vector<int> around;
  for (const int node : seen)
    if ((scene.pixel(scene.cells->nodes[node]) - centre).norm() < radius - 1) around.push_back(node);
  EXPECT_EQ(scene.tool.release({way.back()}), around);
  EXPECT_GE(around.size(), 5u);

  scene.tool.setMode(PickMode::Brush);
  scene.tool.setRadius(5);
  const std::vector<int> row = scene.drag(scene.pixel(Vec3(-0.0205, 0.01, 0.02)), scene.pixel(Vec3(0.0205, 0.01, 0.02)));
  EXPECT_EQ(row, scene.where([](const Vec3& p) { return p.z() > 0.0199 && std::abs(p.y() - 0.01) < 1e-9; })) << "a node beside the brush is not taken";
}

TEST(NodeMap, withoutCellsNothingIsPicked) {
  CellsInSight scene;
  scene.tool.setNodes(nullptr, {});
  EXPECT_TRUE(scene.drag(Vec2(0, 0), Vec2(800, 600)).empty());
}

}  // namespace
}  // namespace glenoid
