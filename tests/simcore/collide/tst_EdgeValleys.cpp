// SPDX-License-Identifier: GPL-3.0-or-later
// A ridge that hangs over another one whose line dips: at the dip's lowest point both of its slopes hold what slides along it.
#include <gtest/gtest.h>

#include <cmath>

#include "tests/simcore/collide/Scene.h"

namespace glenoid {
namespace {

constexpr double kSlope = 0.5;  ///< of the ridge beside the dip

/// A roof along x whose ridge rises from height 0 in the middle with `slope` to both sides; below zero it is a peak.
TriMesh dippedRoof(double slope) {
  TriMesh mesh;
  const double ends[] = {-0.02, 0, 0.02};
  for (const double x : ends) {
    const double y = slope * std::abs(x);
    mesh.vertices.insert(mesh.vertices.end(), {{x, y, 0}, {x, y - 0.01, -0.02}, {x, y - 0.01, 0.02}});
  }
  const auto quad = [&](int a, int b, int c, int d) { mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}}); };
  for (const int i : {0, 3}) {
    quad(i, i + 2, i + 5, i + 3);      // the side toward +z
    quad(i, i + 3, i + 4, i + 1);      // and toward −z
    quad(i + 1, i + 4, i + 5, i + 2);  // its floor
  }
  mesh.triangles.insert(mesh.triangles.end(), {{0, 1, 2}, {6, 8, 7}});
  return mesh;
}

/// A blade whose lower edge lies along z through (x, y, 0).
TriMesh blade(double x, double y) {
  TriMesh mesh;
  mesh.vertices = {{x, y, -0.008}, {x, y, 0.008}, {x - 0.001, y + 0.02, -0.008}, {x - 0.001, y + 0.02, 0.008},
                   {x + 0.001, y + 0.02, -0.008}, {x + 0.001, y + 0.02, 0.008}};
  mesh.triangles = {{0, 3, 2}, {0, 1, 3}, {0, 5, 1}, {0, 4, 5}, {2, 5, 4}, {2, 3, 5}, {0, 2, 4}, {1, 5, 3}};
  if (enclosedVolume(mesh) < 0)
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  return mesh;
}

/// How many contacts of two edges have their normal leaning towards −x and towards +x.
std::array<int, 2> sidesOf(const std::vector<Proximity>& contacts) {
  std::array<int, 2> sides{0, 0};
  for (const Proximity& c : contacts)
    if (c.a.count == 2 && c.b.count == 2) ++sides[c.normal_W.x() > 0];
  return sides;
}

TEST(EdgeValleys, theMeshesAreWhatTheTestsNeed) {
  for (const TriMesh& mesh : {dippedRoof(kSlope), dippedRoof(-kSlope), blade(0, 0)}) {
    EXPECT_GT(enclosedVolume(mesh), 0);
    EXPECT_TRUE(makeCollisionSurface(mesh)->closed);
  }
}

TEST(EdgeValleys, bothSlopesHoldABladeAtTheLowestPointWhateverRoundingSays) {
  for (const double x : {0.0, 1e-18, -1e-18, 1e-12, -1e-9, 1e-7})
    for (const double gap : {1e-4, 1e-9, 0.0, -1e-12, -1e-9, -1e-5, -1e-4, -3e-4}) {
      const auto there = twoMeshes(blade(x, gap), dippedRoof(kSlope)).find(0.001);
      EXPECT_EQ(sidesOf(there), (std::array{1, 1})) << "x " << x << " gap " << gap;
      for (const Proximity& c : there) {
        if (c.a.count != 2 || c.b.count != 2) continue;
        EXPECT_NEAR(c.gap, gap / std::hypot(1, kSlope), std::abs(x) + 1e-14);
      }
      EXPECT_EQ(sidesOf(twoMeshes(dippedRoof(kSlope), blade(x, gap)).find(0.001)), (std::array{1, 1})) << "x " << x << " gap " << gap;
    }
}

TEST(EdgeValleys, theOtherSlopeCountsAsSoonAsTheBladeCanSlideToIt) {
  CollisionScene scene = twoMeshes(blade(-0.0004, 0.0002), dippedRoof(kSlope));  // touches the slope that falls towards +x
  EXPECT_EQ(sidesOf(scene.find(0.001)), (std::array{0, 1}));
  const auto slidingBy = [&](double way) {
    scene.velocities = {std::vector<Vec3>(6, Vec3(way / 0.005, -kSlope * way / 0.005, 0)), {}};
    return sidesOf(scene.find(0.001));
  };
  EXPECT_EQ(slidingBy(0.0001), (std::array{0, 1}));
  EXPECT_EQ(slidingBy(0.0006), (std::array{1, 1}));
}

TEST(EdgeValleys, aPeakHasNoPlanesBeyondItsEnds) {
  // The planes of both of a peak's slopes leave less room than there is; its vertex and one slope at a time say what holds.
  for (const double x : {0.0, 1e-9, -1e-9, 1e-4, -1e-4})
    for (const double vx : {0.0, 0.2, -0.2}) {
      CollisionScene scene = twoMeshes(blade(x, -kSlope * std::abs(x)), dippedRoof(-kSlope));
      scene.velocities = {std::vector<Vec3>(6, Vec3(vx, 0, 0)), {}};
      const auto sides = sidesOf(scene.find(0.001));
      EXPECT_LE(sides[0] + sides[1], 1) << x << " " << vx;
    }
}

}  // namespace
}  // namespace glenoid
