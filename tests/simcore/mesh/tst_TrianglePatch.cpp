// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/mesh/TrianglePatch.h"

#include <gtest/gtest.h>

namespace glenoid {
namespace {

/// A sheet of n × n squares of two triangles, one millimetre each, and a copy of it 10 mm above.
TriMesh twoSheets(int n) {
  TriMesh mesh;
  for (int sheet = 0; sheet < 2; ++sheet) {
    const int first = static_cast<int>(mesh.vertices.size());
    for (int y = 0; y <= n; ++y)
      for (int x = 0; x <= n; ++x) mesh.vertices.push_back(1e-3 * Vec3(x, y, 10.0 * sheet));
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) {
        const int a = first + x + y * (n + 1), b = a + 1, c = a + n + 1, d = c + 1;
        mesh.triangles.push_back({a, b, d});
        mesh.triangles.push_back({a, d, c});
      }
  }
  return mesh;
}

TEST(TrianglePatch, growsByARingAndShrinksBack) {
  const TriMesh mesh = twoSheets(6);
  const int middle = 2 * (2 + 6 * 2);  // first triangle of square (2, 2)
  const std::vector<int> ring = grown(mesh, {middle, middle + 1});
  // Every triangle with a vertex among the square's four: all of the 3 × 3 squares around, without the halves that only
  // touch the square's outer neighbours (two corners where the diagonal runs past).
  EXPECT_EQ(ring.size(), 16u);
  EXPECT_EQ(shrunk(mesh, ring), (std::vector<int>{middle, middle + 1}));
  EXPECT_TRUE(grown(mesh, {}).empty());
  EXPECT_TRUE(shrunk(mesh, {middle}).empty());
}

TEST(TrianglePatch, connectedIsThePieceAndNoOther) {
  const TriMesh mesh = twoSheets(6);
  const std::vector<int> piece = connected(mesh, {5});
  ASSERT_EQ(piece.size(), 72u);
  EXPECT_EQ(piece.back(), 71);
  EXPECT_EQ(inverted(mesh, piece), connected(mesh, {80}));
  EXPECT_EQ(connected(mesh, {5, 80}).size(), 144u);
  EXPECT_EQ(shrunk(mesh, piece), piece) << "nothing outside touches it";
}

TEST(TrianglePatch, areaAddsUp) {
  const TriMesh mesh = twoSheets(6);
  EXPECT_NEAR(areaOf(mesh, {0, 1}), 1e-6, 1e-18);
  EXPECT_NEAR(areaOf(mesh, inverted(mesh, {})), 72e-6, 1e-16);
}

}  // namespace
}  // namespace glenoid
