// SPDX-License-Identifier: GPL-3.0-or-later
// A surface of half a million triangles stays usable: simplified and embedded in seconds, hit by a ray at once.
#include <gtest/gtest.h>

#include <chrono>
#include <cstdio>
#include <ctime>

#include "simcore/embed/Cells.h"
#include "simcore/embed/Fill.h"
#include "simcore/mesh/MeshHealth.h"
#include "simcore/mesh/Simplify.h"
#include "simcore/mesh/TetTools.h"
#include "simcore/spatial/TriangleTree.h"
#include "tests/MachineSpeed.h"
#include "tests/simcore/mesh/Shapes.h"

namespace glenoid {
namespace {

double cpuSeconds() { return static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

TEST(LargeSurface, isSimplifiedAndEmbeddedWithinTenSeconds) {
  const TriMesh mesh = shapes::revolved(
      [](double s) { return Vec2(0.03 * std::sin(M_PI * s) * (1 + 0.1 * std::sin(20 * M_PI * s)), -0.05 * std::cos(M_PI * s)); }, -0.05,
      0.05, 500, 500);
  ASSERT_EQ(mesh.triangles.size(), 500000u);
  const double start = cpuSeconds();
  const auto collision = simplify(mesh, 1000);
  ASSERT_TRUE(collision.ok());
  const double simplified = cpuSeconds();
  const auto cells = chooseCells(mesh, *collision, 3000);
  ASSERT_TRUE(cells.ok());
  const double embedded = cpuSeconds();
  std::printf("500 000 triangles: simplified in %.1f s, cells cut in %.1f s (processor time)\n", simplified - start, embedded - simplified);
  EXPECT_LT(embedded - start, 30 * test::sortingSeconds());  // ten seconds where sorting takes a third of one
  EXPECT_TRUE(healthOf(*collision).healthy());
  EXPECT_NEAR(enclosedVolume(*collision), enclosedVolume(mesh), 1e-6 * enclosedVolume(mesh));
  EXPECT_NEAR(static_cast<double>(cells->mesh.tets.size()), 3000, 450);
  const std::vector<double> enclosed = enclosedVolumes(cells->mesh, mesh);
  double sum = 0;
  for (const double volume : enclosed) sum += volume;
  EXPECT_NEAR(sum, enclosedVolume(mesh), 1e-9 * enclosedVolume(mesh));
}

TEST(LargeSurface, isPickedWithinFiftyMilliseconds) {
  const TriMesh mesh = shapes::sphere(0.05, 500, 501);
  const TriangleTree tree(mesh);
  const double start = cpuSeconds();
  int hits = 0;
  for (int i = 0; i < 1000; ++i) hits += tree.cast(Vec3(0.2, 0.04 * std::sin(i), 0.04 * std::cos(i)), Vec3(-1, 0, 0)).has_value();
  const double each = (cpuSeconds() - start) / 1000;
  std::printf("one ray: %.4f ms\n", each * 1e3);
  EXPECT_EQ(hits, 1000);
  EXPECT_LT(each, 0.05);
}

}  // namespace
}  // namespace glenoid
