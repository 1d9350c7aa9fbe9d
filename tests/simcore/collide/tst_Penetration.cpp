// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "simcore/collide/Penetration.h"
#include "tests/simcore/collide/Scene.h"

namespace glenoid {
namespace {

using namespace shapes;

Penetration deepest(const CollisionScene& scene) {
  return deepestPenetration(scene.surfaces(), scene.pairs, scene.positionSpans());
}

const TriMesh kSlab = box({-0.05, 0, -0.04}, {0.05, 0.03, 0.04});

TEST(Penetration, apartIsZero) {
  const Penetration none = deepest(twoMeshes(box({-0.01, 0.0301, -0.01}, {0.01, 0.05, 0.01}), kSlab));
  EXPECT_EQ(none.depth, 0);
  EXPECT_EQ(none.pair, -1);
}

TEST(Penetration, cornerDepthIsTheDistanceToTheNearestFace) {
  for (const double depth : {1e-6, 1e-3, 0.012}) {
    const CollisionScene scene = twoMeshes(box({-0.01, 0.03 - depth, -0.012}, {0.013, 0.05, 0.01}), kSlab);
    EXPECT_NEAR(deepest(scene).depth, depth, 1e-15);
    EXPECT_NEAR(deepest(twoMeshes(scene.meshes[1], scene.meshes[0])).depth, depth, 1e-15);
  }
}

TEST(Penetration, swallowedSurfaceCounts) {
  const Penetration found = deepest(twoMeshes(sphere({0, 0.012, 0}, 0.001, 1), kSlab));
  EXPECT_NEAR(found.depth, 0.013, 1e-12);  // its top vertex is 17 mm from the top, but 13 mm from the bottom
  EXPECT_EQ(found.pair, 0);
}

TEST(Penetration, edgeThroughAnEdgeIsSeenWithoutAnyVertexInside) {
  // A long thin bar cuts off the slab's upper edge (at y = 30, x = 50 mm): no vertex of either lies in the
  // other.
  const double half = 0.0005, reach = 0.05;
  TriMesh bar = box({-half, -reach, -half}, {half, reach, half});
  const Vec3 middle(0.049, 0.029, 0.003);  // 1 mm inside both faces
  const Quat tilt = Quat::FromTwoVectors(Vec3::UnitY(), Vec3(1, -1, 0).normalized());
  for (Vec3& x : bar.vertices) x = middle + tilt * x;
  const Penetration found = deepest(twoMeshes(bar, kSlab));
  // The lowest long edges lie half further in along the edge's bisector; three samples find the middle of the
  // cut.
  const double expected = 0.001 + half * std::sqrt(0.5);
  EXPECT_LE(found.depth, expected + half);
  EXPECT_GT(found.depth, 0.9 * expected);
  EXPECT_LT((found.point - middle).norm(), 0.003);
}

TEST(Penetration, skippedPartsDoNotCount) {
  CollisionScene scene = twoMeshes(box({-0.01, 0.027, -0.012}, {0.013, 0.05, 0.01}), kSlab);
  EXPECT_NEAR(deepest(scene).depth, 0.003, 1e-15);
  scene.pairs[0].skipTriangleA.assign(12, 1);  // slab's own vertices are not in the box
  EXPECT_EQ(deepest(scene).depth, 0);
  scene.pairs[0].skipTriangleA.clear();
  scene.pairs[0].skipTriangleB.assign(12, 1);
  EXPECT_EQ(deepest(scene).depth, 0);
}

TEST(Penetration, namesTheWorstPairAndRepeats) {
  CollisionScene scene = twoMeshes(box({-0.01, 0.029, -0.01}, {0.01, 0.05, 0.01}), kSlab);
  scene.meshes.push_back(box({0.02, 0.0275, -0.01}, {0.03, 0.05, 0.01}));
  scene.pairs = {{0, 1, {}, {}}, {1, 2, {}, {}}, {0, 2, {}, {}}};
  PenetrationCheck check(scene.surfaces(), scene.pairs);
  for (int i = 0; i < 3; ++i) {
    const Penetration found = check.deepest(scene.positionSpans());
    EXPECT_EQ(found.pair, 1);
    EXPECT_NEAR(found.depth, 0.0025, 1e-15);
  }
  scene.meshes[2].vertices[0].x() = std::nan("");  // that surface is left out
  EXPECT_EQ(check.deepest(scene.positionSpans()).pair, 0);
}

TEST(Penetration, eachPairIsMeasuredByItself) {
  CollisionScene scene = twoMeshes(box({-0.03, 0.028, -0.01}, {-0.01, 0.05, 0.01}), kSlab);
  scene.meshes.push_back(box({0.01, 0.025, -0.01}, {0.03, 0.05, 0.01}));
  scene.meshes.push_back(box({0.01, 0.1, -0.01}, {0.03, 0.12, 0.01}));
  scene.pairs = {{0, 1, {}, {}}, {1, 2, {}, {}}, {1, 3, {}, {}}};
  PenetrationCheck check(scene.surfaces(), scene.pairs);
  std::vector<Penetration> found;
  const auto expectThem = [&](std::array<double, 3> depths) {
    ASSERT_EQ(found.size(), 3u);
    for (int p = 0; p < 3; ++p) {
      EXPECT_NEAR(found[p].depth, depths[p], 1e-15) << p;
      EXPECT_EQ(found[p].pair, depths[p] > 0 ? p : -1) << p;
    }
  };
  check.eachPair(scene.positionSpans(), {}, found);
  expectThem({0.002, 0.005, 0});
  EXPECT_EQ(check.deepest(scene.positionSpans()).pair, 1);
  EXPECT_NEAR(check.deepest(scene.positionSpans()).depth, 0.005, 1e-15);
  const std::vector<double> allowed = {0.0005, 0.006, 0};
  check.eachPair(scene.positionSpans(), allowed, found);
  expectThem({0.0015, 0, 0});
}

TEST(Penetration, finderAndCheckAgreeOnVertices) {
  // Two ways to the same number: the finder's most negative vertex gap and the check's deepest vertex.
  Numbers numbers(21);
  for (int i = 0; i < 30; ++i) {
    Pose pose = numbers.pose(1);
    pose.p_WB *= numbers.in(0.028, 0.031) / pose.p_WB.norm();
    const CollisionScene scene =
        twoMeshes(sphere({0, 0, 0}, 0.02, 2), moved(sphere({0, 0, 0}, 0.012, 2), pose));
    double lowest = 0;
    for (const Proximity& c : scene.find(0.001)) {
      if (c.a.count == 1 || c.b.count == 1) lowest = std::min(lowest, c.gap);
    }
    const double depth = deepest(scene).depth;
    EXPECT_GE(depth, -lowest - 1e-15);
    EXPECT_LT(depth, 0.004);
    if (lowest < -5e-4) {
      EXPECT_LT(depth, -1.5 * lowest);  // edge samples lie between the vertices
    }
  }
}

TEST(StartIntersections, areThosePairsThatAreNotSkipped) {
  CollisionScene scene = twoMeshes(box({-0.01, 0.029, -0.012}, {0.013, 0.05, 0.01}), kSlab);
  const auto run = [&] { return startIntersections(scene.surfaces(), scene.pairs, scene.positionSpans()); };
  const auto found = run();
  ASSERT_EQ(found.size(), 1u);
  EXPECT_EQ(found[0].pair, 0);
  EXPECT_GE(found[0].triangles.size(), 8u);  // eight side triangles pass through the top
  scene.pairs[0].skipTriangleB.assign(12, 1);
  EXPECT_TRUE(run().empty());
  scene = twoMeshes(box({-0.01, 0.0301, -0.012}, {0.013, 0.05, 0.01}), kSlab);
  EXPECT_TRUE(run().empty());
}

}  // namespace
}  // namespace glenoid
