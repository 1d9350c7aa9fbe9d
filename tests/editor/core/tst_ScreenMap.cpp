// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/tools/ScreenMap.h"

#include <gtest/gtest.h>

#include <ctime>
#include <iostream>
#include <map>

#include "editor/core/tools/SelectTool.h"
#include "simcore/spatial/TriangleTree.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

Viewport frontView() {
  Viewport viewport;
  viewport.view.eye_W = Vec3(0.01, 0.02, 0.3);
  viewport.view.target_W = Vec3(0, 0, 0);
  viewport.view.fieldOfView = 0.4;
  viewport.width = 800;
  viewport.height = 600;
  return viewport;
}

Vec3 centreOf(const TriMesh& mesh, int t) {
  Vec3 sum = Vec3::Zero();
  for (const int v : mesh.triangles[t]) sum += mesh.vertices[v] / 3;
  return sum;
}

/// Sphere of 8·4^n triangles.
TriMesh sphere(int n, double radius) {
  TriMesh mesh;
  mesh.vertices = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int i = 0; i < n; ++i) {
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
      const auto [it, isNew] = middles.try_emplace(std::minmax(a, b), static_cast<int>(mesh.vertices.size()));
      if (isNew) mesh.vertices.push_back((mesh.vertices[a] + mesh.vertices[b]).normalized());
      return it->second;
    };
    std::vector<std::array<int, 3>> finer;
    for (const auto& t : mesh.triangles) {
      const int a = middle(t[0], t[1]), b = middle(t[1], t[2]), c = middle(t[2], t[0]);
      for (const auto& f : {std::array{t[0], a, c}, std::array{a, t[1], b}, std::array{c, b, t[2]}, std::array{a, b, c}})
        finer.push_back(f);
    }
    mesh.triangles = std::move(finer);
  }
  for (Vec3& v : mesh.vertices) v *= radius;
  return mesh;
}

/// What is seen, by casting a ray to each centre: slow and independent.
std::vector<char> seenByRays(const Viewport& viewport, const TriMesh& surface, const std::vector<const TriMesh*>& others) {
  const TriangleTree tree(surface);
  std::vector<TriangleTree> more;
  for (const TriMesh* other : others) more.emplace_back(*other);
  std::vector<char> seen;
  for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
    const Vec3 way = centreOf(surface, t) - viewport.view.eye_W;
    const auto hit = tree.cast(viewport.view.eye_W, way);
    bool free = hit && hit->triangle == t && hit->normal.dot(way) < 0;
    for (const TriangleTree& other : more) free = free && !other.cast(viewport.view.eye_W, way, way.norm());
    seen.push_back(free);
  }
  return seen;
}

TEST(ScreenMap, seesWhatRaysSee) {
  const Viewport viewport = frontView();
  const TriMesh ball = sphere(4, 0.03);  // 2048 triangles
  const auto veil = std::make_shared<TriMesh>(scenes::boxSurface(Vec3(0, -0.02, 0.05), Vec3(0.02, 0.02, 0.06), 3));
  const std::vector<std::shared_ptr<const TriMesh>> others = {veil};
  const ScreenMap map(viewport, ball, others);
  const std::vector<char> wanted = seenByRays(viewport, ball, {veil.get()});
  int differ = 0, seen = 0;
  for (int t = 0; t < static_cast<int>(ball.triangles.size()); ++t) {
    differ += map.seen(t) != (wanted[t] != 0);
    seen += wanted[t];
    const auto pixel = projected(viewport.view, centreOf(ball, t), viewport.width, viewport.height);
    // The centre on the screen is that of the corners' pixels: perspective moves it by less than a pixel here.
    EXPECT_LT((map.centres()[t].cast<double>() - *pixel).norm(), 1.0);
  }
  EXPECT_GT(seen, 300);
  // Only along the silhouette and the veil's edge may a pixel decide otherwise than a ray.
  EXPECT_LE(differ, seen / 40);
}

TEST(ScreenMap, takesTheNearestUnderThePixel) {
  const Viewport viewport = frontView();
  const TriMesh box = scenes::boxSurface(Vec3(-0.02, -0.02, -0.02), Vec3(0.02, 0.02, 0.02), 4);
  const auto veil = std::make_shared<TriMesh>(scenes::boxSurface(Vec3(0, -0.02, 0.05), Vec3(0.02, 0.02, 0.06), 1));
  const std::vector<std::shared_ptr<const TriMesh>> others = {veil};
  const ScreenMap map(viewport, box, others);
  const TriangleTree tree(box);
  for (const Vec3& p : {Vec3(-0.011, 0.004, 0.02), Vec3(0.004, 0.003, 0.02)}) {
    const Vec2 pixel = *projected(viewport.view, p, viewport.width, viewport.height);
    const auto hit = tree.cast(viewport.view.eye_W, p - viewport.view.eye_W);
    EXPECT_EQ(map.triangleAt(pixel, true), hit->triangle);
    EXPECT_EQ(map.triangleAt(pixel, false), p.x() < 0 ? hit->triangle : -1) << "the veil is before the second";
  }
  EXPECT_EQ(map.triangleAt(Vec2(2, 2), true), -1);
  EXPECT_EQ(map.triangleAt(Vec2(-50, 1e6), true), -1);
}

TEST(ScreenMap, whatIsBehindTheEyeIsNotSeen) {
  Viewport viewport = frontView();
  viewport.view.eye_W = Vec3(0, 0, 0);
  viewport.view.target_W = Vec3(0, 0, -0.1);
  const TriMesh ball = sphere(3, 0.03);
  const ScreenMap map(viewport, ball, {});
  for (int t = 0; t < static_cast<int>(ball.triangles.size()); ++t) EXPECT_FALSE(map.seen(t)) << "inside: all turned away";
}

TEST(ScreenMap, halfAMillionTrianglesWithinFiftyMilliseconds) {
  Viewport viewport = frontView();
  viewport.width = 1280;
  viewport.height = 800;
  const TriMesh ball = sphere(8, 0.03);
  ASSERT_EQ(ball.triangles.size(), 524288u);
  // Thread CPU time: other programs of the machine shall not decide. On an idle one it is what a person waits.
  const auto timed = [](auto&& run) {
    const auto now = [] {
      timespec time{};
      clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
      return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
    };
    const double before = now();
    run();
    return now() - before;
  };
  double best = 1e9;
  for (int i = 0; i < 5; ++i) {
    best = std::min(best, timed([&] {
      const ScreenMap map(viewport, ball, {});
      EXPECT_GE(map.triangleAt(Vec2(640, 400), false), 0);
    }));
  }
  // One that is painted: the map once when the button goes down, then each movement.
  SelectTool tool;
  tool.setTarget(std::make_shared<TriMesh>(ball), {});
  tool.setRadius(40);
  double press = 1e9, move = 1e9;
  for (int i = 0; i < 5; ++i) {
    viewport.view.eye_W.x() += 1e-6;  // another view: the map is made anew
    press = std::min(press, timed([&] { tool.press(viewport, {Vec2(600, 400)}, {}); }));
    for (int k = 1; k < 5; ++k) move = std::min(move, timed([&] { tool.move({Vec2(600 + 10 * k, 400)}); }));
    EXPECT_GT(tool.release({Vec2(640, 400)}).size(), 1000u);
  }
  std::cout << "524288 triangles: map " << best << " ms, press " << press << " ms, move " << move << " ms\n";
  EXPECT_LT(best, 50);
  EXPECT_LT(press, 50);
  EXPECT_LT(move, 25);
}

}  // namespace
}  // namespace glenoid
