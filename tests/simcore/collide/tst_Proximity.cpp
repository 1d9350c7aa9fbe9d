// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <limits>

#include <algorithm>
#include <set>

#include "tests/simcore/collide/Scene.h"
#include "tests/simcore/collide/SlowProximity.h"

namespace glenoid {
namespace {

using namespace shapes;

int count(const std::vector<Proximity>& contacts, int featureA, int featureB) {
  return static_cast<int>(std::count_if(contacts.begin(), contacts.end(), [&](const Proximity& c) {
    return c.a.count == featureA && c.b.count == featureB;
  }));
}

TEST(CollisionSurface, knowsItsTopology) {
  const auto surface = makeCollisionSurface(sphere({0, 0, 0}, 1, 2));
  EXPECT_TRUE(surface->closed);
  EXPECT_EQ(surface->triangles.size(), 128u);
  EXPECT_EQ(surface->edges.size(), 192u);  // 3 F / 2
  EXPECT_EQ(surface->vertexCount - 192 + 128, 2);
  for (int e = 0; e < 192; ++e) {
    const auto& edge = surface->edges[e];
    EXPECT_LT(edge.vertices[0], edge.vertices[1]);
    for (int k = 0; k < 2; ++k) {
      const auto& own = surface->triangleEdges[edge.triangles[k]];
      const auto& corners = surface->triangles[edge.triangles[k]];
      EXPECT_EQ(std::count(own.begin(), own.end(), e), 1);
      EXPECT_EQ(std::count(corners.begin(), corners.end(), edge.opposite[k]), 1);
      EXPECT_NE(edge.opposite[k], edge.vertices[0]);
      EXPECT_NE(edge.opposite[k], edge.vertices[1]);
    }
  }
  for (int v = 0; v < surface->vertexCount; ++v) {
    EXPECT_EQ(surface->trianglesOf(v).size(), surface->edgesOf(v).size());  // closed fan
    for (const int t : surface->trianglesOf(v)) {
      EXPECT_EQ(std::count(surface->triangles[t].begin(), surface->triangles[t].end(), v), 1);
    }
  }
  TriMesh open = box({0, 0, 0}, {1, 1, 1});
  open.triangles.pop_back();
  EXPECT_FALSE(makeCollisionSurface(open)->closed);
  TriMesh turned = box({0, 0, 0}, {1, 1, 1});
  std::swap(turned.triangles[3][0], turned.triangles[3][1]);
  EXPECT_FALSE(makeCollisionSurface(turned)->closed);
}

TEST(Proximity, boxOverBoxGivesItsFourCorners) {
  const CollisionScene scene = twoMeshes(box({-0.01, 0.0305, -0.012}, {0.013, 0.05, 0.01}),
                                         box({-0.05, 0, -0.04}, {0.05, 0.03, 0.04}));
  const auto contacts = scene.find(0.001);
  ASSERT_EQ(contacts.size(), 4u);
  std::set<int> corners;
  for (const Proximity& c : contacts) {
    EXPECT_EQ(c.a.count, 1);
    EXPECT_EQ(c.b.count, 3);
    EXPECT_NEAR(c.gap, 0.0005, 1e-15);
    EXPECT_LT((c.normal_W - Vec3::UnitY()).norm(), 1e-15);
    EXPECT_NEAR(c.normal_W.dot(scene.at(0, c.a) - scene.at(1, c.b)), c.gap, 1e-15);
    corners.insert(c.a.vertex[0]);
  }
  EXPECT_EQ(corners, (std::set<int>{0, 1, 4, 5}));
  EXPECT_TRUE(scene.find(0.0004).empty());
}

TEST(Proximity, touchingAndSunkenCornersStayFour) {
  for (const double sink : {0.0, 1e-12, 1e-9, 1e-6, 1e-3, 3.5e-3}) {
    const CollisionScene scene = twoMeshes(box({-0.01, 0.03 - sink, -0.012}, {0.013, 0.05, 0.01}),
                                           box({-0.05, 0, -0.04}, {0.05, 0.03, 0.04}));
    const auto contacts = scene.find(0.001);
    ASSERT_EQ(contacts.size(), 4u) << sink;
    for (const Proximity& c : contacts) {
      EXPECT_EQ(c.a.count, 1);
      EXPECT_NEAR(c.gap, -sink, 1e-14);
      EXPECT_LT((c.normal_W - Vec3::UnitY()).norm(), 1e-12);
    }
  }
  // Below the depth limit nothing is known any more.
  const CollisionScene deep = twoMeshes(box({-0.01, 0.024, -0.012}, {0.013, 0.05, 0.01}), box({-0.05, 0, -0.04}, {0.05, 0.03, 0.04}));
  EXPECT_EQ(deep.find(0.001).size(), 4u);
  EXPECT_TRUE(deep.find(0.001, 0.005, {0.1, 0.1}).empty());
}

TEST(Proximity, swappedSurfacesGiveTheOppositeNormal) {
  const TriMesh ball = sphere({0, 0.0405, 0}, 0.01, 2), slab = box({-0.05, 0, -0.04}, {0.05, 0.03, 0.04});
  const auto there = twoMeshes(ball, slab).find(0.001), back = twoMeshes(slab, ball).find(0.001);
  ASSERT_EQ(there.size(), back.size());
  ASSERT_FALSE(there.empty());
  std::map<std::vector<int>, Proximity> byName;
  for (const Proximity& c : there) byName[featureName(c)] = c;
  for (Proximity c : back) {
    std::swap(c.a, c.b);
    ASSERT_EQ(byName.count(featureName(c)), 1u);
    EXPECT_LT((byName[featureName(c)].normal_W + c.normal_W).norm(), 1e-15);
    EXPECT_EQ(byName[featureName(c)].gap, c.gap);
  }
}

TEST(Proximity, ballOverPlaneTouchesWithItsLowestVertexAlone) {
  const CollisionScene scene =
      twoMeshes(sphere({0.003, 0.0405, 0.001}, 0.01, 3), box({-0.05, 0, -0.04}, {0.05, 0.03, 0.04}));
  const auto contacts = scene.find(0.001);
  // Many are near; the nearest of the ball is one, and for each other one a neighbour lies nearer.
  const auto& ball = scene.meshes[0].vertices;
  const auto lowest = std::min_element(ball.begin(), ball.end(), [](const Vec3& p, const Vec3& q) { return p.y() < q.y(); });
  EXPECT_GT(std::count_if(ball.begin(), ball.end(), [](const Vec3& p) { return p.y() - 0.03 < 0.001; }), 1);
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_EQ(contacts[0].a.count, 1);
  EXPECT_EQ(contacts[0].a.vertex[0], lowest - ball.begin());
  EXPECT_NEAR(contacts[0].gap, lowest->y() - 0.03, 1e-15);
  EXPECT_LT((contacts[0].normal_W - Vec3::UnitY()).norm(), 1e-14);
}

TEST(Proximity, aBallThatRollsTouchesWithWhatComesDownWithinTheStep) {
  CollisionScene scene = twoMeshes(sphere({0.003, 0.0405, 0.001}, 0.01, 3), box({-0.05, 0, -0.04}, {0.05, 0.03, 0.04}));
  const std::size_t still = scene.find(0.001).size();
  scene.velocities = {{}, std::vector<Vec3>(8, Vec3::Zero())};
  for (const Vec3& x : scene.meshes[0].vertices) scene.velocities[0].push_back(Vec3(0, 0, -60).cross(x - Vec3(0.003, 0.0405, 0.001)));
  const auto rolling = scene.find(0.001);  // by 0.3 rad within the step
  EXPECT_GT(rolling.size(), still);
  for (const Proximity& c : rolling) EXPECT_LT((c.normal_W - Vec3::UnitY()).norm(), 1e-14);
}

TEST(Proximity, deepCornerLeavesThroughTheNearestFace) {
  // A spike 3 mm under the top of a slab, 20 mm from its sides.
  TriMesh spike;
  spike.vertices = {{0, 0.027, 0}, {0.01, 0.06, 0}, {-0.005, 0.06, 0.009}, {-0.005, 0.06, -0.009}};
  spike.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  ASSERT_GT(enclosedVolume(spike), 0);
  const CollisionScene scene = twoMeshes(spike, box({-0.02, 0, -0.02}, {0.025, 0.03, 0.02}));
  const auto contacts = scene.find(0.001);
  ASSERT_EQ(count(contacts, 1, 3), 1);
  const Proximity& c = contacts[0];
  EXPECT_NEAR(c.gap, -0.003, 1e-15);
  EXPECT_LT((c.normal_W - Vec3::UnitY()).norm(), 1e-15);
  EXPECT_EQ(c.a.vertex[0], 0);
}

TEST(Proximity, thinSheetPushesBackTheWayTheVertexCame) {
  // 0.7 mm into a sheet of 1.1 mm: the far face is nearer, the spike still goes back up.
  TriMesh spike;
  spike.vertices = {{0, 0.0004, 0}, {0.01, 0.03, 0}, {-0.005, 0.03, 0.009}, {-0.005, 0.03, -0.009}};
  spike.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  const auto contacts = twoMeshes(spike, box({-0.02, 0, -0.02}, {0.025, 0.0011, 0.02})).find(0.0005);
  ASSERT_EQ(contacts.size(), 1u);
  EXPECT_NEAR(contacts[0].gap, -0.0007, 1e-15);
  EXPECT_LT((contacts[0].normal_W - Vec3::UnitY()).norm(), 1e-15);
}

TEST(Proximity, farSideOfAThinSheetGivesNothing) {
  // A sheet of 0.3 mm hovers 0.2 mm over a slab: only its lower corners are contacts.
  const auto contacts = twoMeshes(box({-0.01, 0.0302, -0.01}, {0.011, 0.0305, 0.012}),
                                  box({-0.05, 0, -0.04}, {0.05, 0.03, 0.04}))
                            .find(0.0015);
  ASSERT_EQ(contacts.size(), 4u);
  for (const Proximity& c : contacts) EXPECT_NEAR(c.gap, 0.0002, 1e-15);
}

/// A roof whose ridge, along z before turning, lies at height y; the other one hangs upside down.
TriMesh roof(double y, double angle, bool hanging) {
  TriMesh mesh;
  const double s = hanging ? 1 : -1;
  mesh.vertices = {{0, 0, -0.02},
                   {0, 0, 0.02},
                   {-0.01, s * 0.01, -0.021},
                   {-0.01, s * 0.01, 0.021},
                   {0.01, s * 0.01, -0.021},
                   {0.01, s * 0.01, 0.021}};
  mesh.triangles = {{0, 2, 3}, {0, 3, 1}, {0, 1, 5}, {0, 5, 4}, {2, 4, 5}, {2, 5, 3}, {0, 4, 2}, {1, 3, 5}};
  if (enclosedVolume(mesh) < 0) {
    for (auto& t : mesh.triangles) std::swap(t[1], t[2]);
  }
  return moved(mesh, poseOf({0, y, 0}, Vec3::UnitY(), angle));
}

TEST(Proximity, crossingEdgesGiveOneContactOutsideAndInside) {
  for (const double gap : {0.0008, 1e-6, 0.0, -1e-6, -0.0008, -0.0015}) {
    const CollisionScene scene = twoMeshes(roof(gap, 1.2, true), roof(0, 0, false));
    const auto contacts = scene.find(0.001);
    ASSERT_EQ(contacts.size(), 1u) << gap;
    EXPECT_EQ(contacts[0].a.count, 2);
    EXPECT_EQ(contacts[0].b.count, 2);
    EXPECT_NEAR(contacts[0].gap, gap, 1e-15);
    EXPECT_LT((contacts[0].normal_W - Vec3::UnitY()).norm(), 1e-14);
    EXPECT_LT((scene.at(0, contacts[0].a) - Vec3(0, gap, 0)).norm(), 1e-15);
    EXPECT_LT((scene.at(1, contacts[0].b)).norm(), 1e-15);
  }
}

TEST(Proximity, lookAheadFollowsTheClosingSpeedUpToItsCap) {
  CollisionScene scene =
      twoMeshes(box({-0.01, 0.033, -0.012}, {0.013, 0.05, 0.01}), box({-0.05, 0, -0.04}, {0.05, 0.03, 0.04}));
  const auto countAt = [&](const Vec3& vA, const Vec3& vB) {
    scene.velocities = {std::vector<Vec3>(8, vA), std::vector<Vec3>(8, vB)};
    return scene.find(0.0015, 0.005).size();
  };
  EXPECT_EQ(countAt({0, 0, 0}, {0, 0, 0}), 0u);        // gap 3 mm
  EXPECT_EQ(countAt({0, -0.29, 0}, {0, 0, 0}), 0u);    // 1.5 + 1.45 mm
  EXPECT_EQ(countAt({0, -0.31, 0}, {0, 0, 0}), 4u);    // 1.5 + 1.55 mm
  EXPECT_EQ(countAt({0, -0.2, 0}, {0, 0.11, 0}), 4u);  // shared between both
  EXPECT_EQ(countAt({0, -1, 0}, {0, -1, 0}), 0u);      // together
  EXPECT_EQ(countAt({3, 1, 3}, {0, 0, 0}), 0u);        // along and away
  // The cap is twice the sizes of both: 0.36 m here.
  scene.meshes[0] = box({-0.01, 0.33, -0.012}, {0.013, 0.35, 0.01});
  EXPECT_EQ(countAt({0, -70, 0}, {0, 0, 0}), 4u);
  scene.meshes[0] = box({-0.01, 0.43, -0.012}, {0.013, 0.45, 0.01});
  EXPECT_EQ(countAt({0, -1e6, 0}, {0, 0, 0}), 0u);
}

/// A spike whose tip hangs at `tip`, over a plate with a groove of slope `rise` along Z at x = 0.
CollisionScene spikeOverGroove(const Vec3& tip, double rise) {
  TriMesh groove;
  for (const double z : {-0.02, 0.02})
    for (const double x : {-0.02, 0.0, 0.02}) {
      groove.vertices.push_back({x, std::abs(x) * rise, z});
      groove.vertices.push_back({x, -0.02, z});
    }
  // Two prisms side by side, their common wall left out.
  const auto quad = [&](int a, int b, int c, int d) {
    groove.triangles.push_back({a, b, c});
    groove.triangles.push_back({a, c, d});
  };
  for (const int x : {0, 2}) {
    quad(x, x + 6, x + 8, x + 2);      // top
    quad(x + 1, x + 3, x + 9, x + 7);  // bottom
    quad(x, x + 2, x + 3, x + 1);      // ends
    quad(x + 6, x + 7, x + 9, x + 8);
  }
  quad(0, 1, 7, 6);
  quad(4, 10, 11, 5);
  TriMesh spike;
  spike.vertices = {tip, tip + Vec3(-0.001, 0.02, -0.001), tip + Vec3(0.001, 0.02, -0.001), tip + Vec3(0, 0.02, 0.001)};
  spike.triangles = {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}};
  return twoMeshes(groove, spike);
}

TEST(Proximity, tipInAValleyMeetsBothOfItsSides) {
  const double rise = 0.1, sine = 0.1 / std::sqrt(1.01);
  // Above, touching and below; left of the edge, on it, and right of it.
  for (const double y : {5e-5, 0.0, -2e-4})
    for (const double x : {-2e-4, 0.0, 1e-5, 2e-4}) {
      const auto found = spikeOverGroove({x, y + std::abs(x) * rise, 0.003}, rise).find(0.0015);
      double left = 0, right = 0;
      for (const Proximity& c : found) {
        // From the spike to the groove, so against the outward normal.
        EXPECT_NEAR(std::abs(c.normal_W.x()), sine, 1e-9) << "a plane of one of the sides";
        (c.normal_W.x() < 0 ? left : right) += 1;
        const double side = c.normal_W.x() < 0 ? 1 : -1;
        EXPECT_NEAR(c.gap, (y + std::abs(x) * rise + side * x * rise) / std::sqrt(1.01), 1e-12);
      }
      EXPECT_GE(left, 1) << x << ' ' << y;
      EXPECT_GE(right, 1) << x << ' ' << y;
    }
}

TEST(Proximity, farFromAValleyItsOtherSideIsLeftAlone) {
  const auto found = spikeOverGroove({2.5e-3, 2.6e-4, 0.003}, 0.1).find(0.0015);
  ASSERT_EQ(found.size(), 1u);
}

TEST(Proximity, equalsBruteForceOverAllFeatures) {
  Numbers numbers(11);
  int positive = 0, negative = 0, edges = 0, dents = 0;
  // Curved, flat and saddle-shaped surfaces, near, touching and up to some millimetres inside each other.
  for (int i = 0; i < 200; ++i) {
    TriMesh a = i % 3 == 0 ? sphere({0, 0, 0}, 0.02, 2)
                           : (i % 3 == 1 ? torus(0.02, 0.008, 15, 9)
                                         : box({-0.015, -0.01, -0.02}, {0.01, 0.02, 0.01}));
    TriMesh b = i % 2 == 0 ? torus(0.025, 0.01, 13, 8) : sphere({0, 0, 0}, 0.018, 1);
    a = moved(a, numbers.pose(0.0));
    Pose pose = numbers.pose(1.0);
    pose.p_WB *= numbers.in(0.025, 0.045) / pose.p_WB.norm();
    b = moved(b, pose);
    const double contactDistance = 0.0015;
    // Nearest ways only: the rows of deep overlaps are tst_DeepOverlap's.
    const ProximityLimits limits{0.4, 0.25, std::numeric_limits<double>::infinity()};
    CollisionScene scene = twoMeshes(a, b);
    scene.deforms = {i % 4 >= 2, i % 8 >= 4};
    const auto slow = slowProximities(a, b, contactDistance, limits, scene.deforms);
    const auto found = scene.find(contactDistance, 0.005, limits);
    dents += found.size() > twoMeshes(a, b).find(contactDistance, 0.005, limits).size();
    std::set<std::vector<int>> names;
    for (const Proximity& c : found) {
      EXPECT_TRUE(names.insert(featureName(c)).second);
      const auto match = slow.find(featureName(c));
      ASSERT_NE(match, slow.end()) << i << ": not expected, gap " << c.gap << ", " << c.a.count << " "
                                   << c.b.count;
      EXPECT_NEAR(match->second.gap, c.gap, 1e-13);
      EXPECT_LT((match->second.normal_W - c.normal_W).norm(),
                1e-8);  // a direction over a gap that may be tiny
      (c.gap < 0 ? negative : positive) += 1;
      edges += c.a.count == 2 && c.b.count == 2;
    }
    for (const auto& [name, contact] : slow)
      if (std::abs(contact.gap) > 1e-4 * contactDistance)  // what touches is told by its cones
        EXPECT_EQ(names.count(name), 1u) << i << ": missed, gap " << contact.gap;
  }
  EXPECT_GT(positive, 40);
  EXPECT_GT(negative, 50);
  EXPECT_GT(edges, 20);
  EXPECT_GT(dents, 5);
}

TEST(Proximity, aRidgeAcrossASoftFaceTouchesItBetweenTheVertices) {
  // The lower edge of a bar lies along x across the top of a plate, a little inside. All vertices of either are
  // far from the other; only the diagonal of the plate's top can say how deep the bar is.
  TriMesh bar = box({-0.05, -0.002, -0.002}, {0.05, 0.002, 0.002});
  const Quat onEdge(Eigen::AngleAxisd(std::numbers::pi / 4, Vec3::UnitX()));
  for (Vec3& x : bar.vertices) x = onEdge * x + Vec3(0, std::sqrt(8.0) * 1e-3 - 1e-4, 1e-3);
  CollisionScene scene = twoMeshes(bar, box({-0.02, -0.01, -0.02}, {0.02, 0, 0.02}));
  const auto across = [&] {
    std::vector<Proximity> list;
    for (const Proximity& c : scene.find(5e-4))
      if (c.a.count == 2 && c.b.count == 2 && c.normal_W.y() > 0.999) list.push_back(c);
    return list;
  };
  const std::size_t rigid = across().size();
  scene.deforms = {false, true};
  const auto soft = across();
  EXPECT_EQ(soft.size(), rigid + 1);
  for (const Proximity& c : soft) EXPECT_NEAR(c.gap, -1e-4, 1e-12);
}

TEST(Proximity, aBladeThatLeansOverGoesNoDeeperThanItsEdge) {
  // A thin wedge lying almost flat with its edge across the convex edge of a bar, both edges a little past each
  // other: the bar's point under the wedge's edge comes out on the wedge's other side, so it says nothing.
  TriMesh blade;
  blade.vertices = {{0, 0, -0.02}, {0, 0, 0.02}, {0.02, 0.004, -0.02}, {0.02, 0.004, 0.02}, {0.02, 0.008, -0.02}, {0.02, 0.008, 0.02}};
  blade.triangles = {{0, 3, 1}, {0, 2, 3}, {0, 1, 5}, {0, 5, 4}, {2, 5, 3}, {2, 4, 5}, {0, 4, 2}, {1, 3, 5}};
  TriMesh bar = box({-0.05, -0.002, -0.002}, {0.05, 0.002, 0.002});
  const Quat onEdge(Eigen::AngleAxisd(std::numbers::pi / 4, Vec3::UnitX()));
  for (Vec3& x : bar.vertices) x = onEdge * x + Vec3(0, -std::sqrt(8.0) * 1e-3 + 2e-4, 0);
  const auto found = twoMeshes(blade, bar).find(1e-4);
  const auto edges = std::count_if(found.begin(), found.end(), [](const Proximity& c) { return c.a.count == 2 && c.b.count == 2; });
  EXPECT_EQ(edges, 1);
  for (const Proximity& c : found)
    if (c.a.count == 2 && c.b.count == 2) {
      EXPECT_NEAR(c.gap, -2e-4, 1e-12);
      EXPECT_GT(c.normal_W.y(), 0.999);
    }
}

TEST(Proximity, turnsWithTheScene) {
  Numbers numbers(12);
  for (int i = 0; i < 20; ++i) {
    Pose offset = numbers.pose(1);
    offset.p_WB *= numbers.in(0.028, 0.034) / offset.p_WB.norm();
    const TriMesh a = torus(0.02, 0.008, 15, 9), b = moved(sphere({0, 0, 0}, 0.015, 2), offset);
    const Pose world = numbers.pose(0.3);
    const auto here = twoMeshes(a, b).find(0.0015),
               there = twoMeshes(moved(a, world), moved(b, world)).find(0.0015);
    ASSERT_EQ(here.size(), there.size());
    for (std::size_t k = 0; k < here.size(); ++k) {
      EXPECT_EQ(here[k].key, there[k].key);
      EXPECT_NEAR(here[k].gap, there[k].gap, 1e-14);
      EXPECT_LT((world.q_WB * here[k].normal_W - there[k].normal_W).norm(), 1e-9);
    }
  }
}

TEST(Proximity, keysStayWhileFeaturesDo) {
  CollisionScene scene = twoMeshes(box({-0.01, 0.0305, -0.012}, {0.013, 0.05, 0.01}),
                                   box({-0.05, 0, -0.04}, {0.05, 0.03, 0.04}));
  scene.meshes.push_back(sphere({0.2, 0.2, 0.2}, 0.01, 1));
  scene.pairs = {{2, 1, {}, {}}, {0, 1, {}, {}}};
  ProximityFinder finder(scene.surfaces(), scene.pairs);
  std::vector<std::uint64_t> first;
  for (int i = 0; i < 10; ++i) {
    for (Vec3& x : scene.meshes[0].vertices)
      x += Vec3(1e-4, -8e-5, 5e-5);  // from 0.5 mm above to 0.3 mm inside
    std::vector<std::uint64_t> keys;
    for (const Proximity& c : finder.find(scene.positionSpans(), {}, 0.001, 0.005)) {
      EXPECT_EQ(c.pair, 1);
      keys.push_back(c.key);
    }
    EXPECT_TRUE(std::is_sorted(keys.begin(), keys.end()));
    EXPECT_EQ(std::adjacent_find(keys.begin(), keys.end()), keys.end());
    if (i == 0) first = keys;
    EXPECT_EQ(keys, first);
  }
  EXPECT_EQ(first.size(), 4u);
}

TEST(Proximity, skippedTrianglesTakeNoPart) {
  const TriMesh slab = box({-0.05, 0, -0.04}, {0.05, 0.03, 0.04});
  for (const double height : {0.0005, -0.0005}) {
    CollisionScene scene = twoMeshes(box({-0.01, 0.03 + height, -0.012}, {0.013, 0.05, 0.01}), slab);
    EXPECT_EQ(scene.find(0.001).size(), 4u);
    std::vector<char> top(12, 0);
    for (int t = 0; t < 12; ++t) {
      bool upper = true;
      for (const int v : slab.triangles[t]) upper &= slab.vertices[v].y() > 0.02;
      top[t] = upper;
    }
    scene.pairs[0].skipTriangleB = top;
    EXPECT_TRUE(scene.find(0.001).empty());
    scene.pairs[0].skipTriangleB.clear();
    scene.pairs[0].skipTriangleA.assign(12, 1);
    EXPECT_TRUE(scene.find(0.001).empty());
    scene.pairs[0].skipTriangleA.assign(12, 0);
    for (const int t : {4, 5})
      scene.pairs[0].skipTriangleA[t] = 1;  // the lower face; its corners have others
    EXPECT_EQ(scene.find(0.001).size(), 4u);
  }
}

TEST(Proximity, whatIsSkippedDoesNotSayWhatIsNearest) {
  // A tilted box whose low side hangs beside a slab: with its whole surface it meets the slab's rim, and the corners on
  // the high side are no nearest points. Where the low side is skipped, as near a coupling, those corners carry it; both
  // ways round, from outside and touching.
  for (const double height : {0.0005, 0.0, -0.0002}) {
    const TriMesh slab = box({-0.05, 0, -0.04}, {0.05, 0.03, 0.04});
    TriMesh tilted = box({-0.01, 0, 0}, {0.013, 0.02, 0.03});
    const Quat turn(Eigen::AngleAxisd(0.12, Vec3::UnitX()));
    for (Vec3& v : tilted.vertices) v = turn * v + Vec3(0, 0.03 + height, 0.03);
    std::vector<char> low(12, 0);
    for (int t = 0; t < 12; ++t)
      for (const int v : tilted.triangles[t]) low[t] |= tilted.vertices[v].z() > 0.05 && tilted.vertices[v].y() < 0.04;
    CollisionScene scene = twoMeshes(tilted, slab), swapped = twoMeshes(slab, tilted);
    if (height >= 0) EXPECT_EQ(count(scene.find(0.001), 1, 3), 0) << height;  // what is inside is pushed out anyway
    scene.pairs[0].skipTriangleA = low;
    swapped.pairs[0].skipTriangleB = low;
    EXPECT_EQ(count(scene.find(0.001), 1, 3), 2) << height;
    EXPECT_EQ(count(swapped.find(0.001), 3, 1), 2) << height;
    for (const Proximity& contact : scene.find(0.001))
      if (contact.a.count == 1) EXPECT_NEAR((contact.normal_W - Vec3::UnitY()).norm(), 0, 1e-12);
  }
}

TEST(Proximity, swallowedSurfaceIsPushedOut) {
  // A pebble of 1 mm wholly inside a slab, 1.5 mm under its top: no triangles meet.
  const auto contacts =
      twoMeshes(sphere({0.01, 0.0285, 0}, 0.0005, 1), box({-0.05, 0, -0.04}, {0.05, 0.03, 0.04}))
          .find(0.0005);
  EXPECT_EQ(contacts.size(), 18u);  // all its vertices
  for (const Proximity& c : contacts) EXPECT_LT((c.normal_W - Vec3::UnitY()).norm(), 1e-14);
}

TEST(Proximity, whatIsSwallowedLeavesByOneSide) {
  // The same in a slab that is thin enough for the other side to be in reach.
  const auto contacts = twoMeshes(sphere({0.01, 0.0085, 0}, 0.0005, 1), box({-0.05, 0, -0.04}, {0.05, 0.01, 0.04})).find(0.0005);
  EXPECT_EQ(contacts.size(), 18u);
  for (const Proximity& c : contacts) EXPECT_LT((c.normal_W - Vec3::UnitY()).norm(), 1e-14);
}

TEST(Proximity, notFinitePositionsGiveNoContact) {
  CollisionScene scene = twoMeshes(box({-0.01, 0.0305, -0.012}, {0.013, 0.05, 0.01}),
                                   box({-0.05, 0, -0.04}, {0.05, 0.03, 0.04}));
  scene.meshes[1].vertices[3].x() = std::nan("");
  ProximityFinder finder(twoMeshes(box({0, 0, 0}, {1, 1, 1}), box({0, 0, 0}, {1, 1, 1})).surfaces(),
                         scene.pairs);
  EXPECT_TRUE(finder.find(scene.positionSpans(), {}, 0.001, 0.005).empty());
  scene.meshes[1].vertices[3].x() = 0.05;
  EXPECT_EQ(finder.find(scene.positionSpans(), {}, 0.001, 0.005).size(), 4u);
}

TEST(Proximity, eachSurfaceMayFollowAnyOfTheMotions) {
  CollisionScene scene =
      twoMeshes(box({-0.01, 0.035, -0.012}, {0.013, 0.05, 0.01}), box({-0.05, 0, -0.04}, {0.05, 0.03, 0.04}));
  ProximityFinder finder(scene.surfaces(), scene.pairs);
  const std::vector<Vec3> still(8, Vec3::Zero()), down(8, Vec3(0, -0.4, 0)), up(8, Vec3(0, 0.4, 0));
  const auto countOf = [&](const std::vector<std::array<const std::vector<Vec3>*, 2>>& wishes) {
    std::vector<std::vector<std::span<const Vec3>>> spans;
    for (const auto& [a, b] : wishes) spans.push_back({*a, *b});
    std::vector<ProximityFinder::Motion> motions(spans.begin(), spans.end());
    return finder.findAlong(scene.positionSpans(), motions, 0.0015, 0.005).size();
  };
  // The gap is 5 mm; each side can close 2 mm of it.
  EXPECT_EQ(countOf({}), 0u);
  EXPECT_EQ(countOf({{&down, &still}}), 0u);
  EXPECT_EQ(countOf({{&down, &up}}), 4u);
  EXPECT_EQ(countOf({{&still, &still}, {&down, &up}}), 4u);
  EXPECT_EQ(countOf({{&down, &still}, {&still, &up}}), 4u) << "one side follows the first, the other the second";
  EXPECT_EQ(countOf({{&down, &down}, {&up, &up}}), 4u) << "as above";
  EXPECT_EQ(countOf({{&up, &down}, {&still, &still}}), 0u) << "apart";
}

TEST(CollisionSurface, trianglesWithoutAFaceCarryNothing) {
  TriMesh mesh = box({0, 0, 0}, {1, 1, 1});
  const auto whole = makeCollisionSurface(mesh);
  const auto first = mesh.triangles[0];
  mesh.vertices.push_back(0.5 * (mesh.vertices[first[0]] + mesh.vertices[first[1]]));
  // They stand first, where they would be taken first.
  mesh.triangles.insert(mesh.triangles.begin(), {{first[0], first[1], 8}, {first[2], first[2], first[0]}});
  mesh.triangles.push_back(first);
  const auto surface = makeCollisionSurface(mesh);
  for (const auto& edge : whole->edges) {
    const auto same = std::find_if(surface->edges.begin(), surface->edges.end(), [&](const auto& e) { return e.vertices == edge.vertices; });
    ASSERT_NE(same, surface->edges.end());
    EXPECT_EQ(same->triangles[0], edge.triangles[0] + 2);
    EXPECT_EQ(same->triangles[1], edge.triangles[1] + 2);
  }
  EXPECT_TRUE(surface->trianglesOf(8).empty());
}

TEST(Proximity, trianglesWithoutAFaceChangeNothing) {
  // Points above, on and below a slab, one of whose faces holds flat triangles of all kinds.
  TriMesh slab = box({-0.05, 0, -0.04}, {0.05, 0.03, 0.04});
  const CollisionSurface plain = *makeCollisionSurface(slab);
  TriMesh flat = slab;
  for (const auto& t : slab.triangles) {
    flat.triangles.push_back({t[0], t[1], t[1]});
    flat.triangles.push_back({t[2], t[2], t[2]});
    flat.triangles.push_back(t);
    flat.triangles.push_back(t);
    flat.vertices.push_back(0.3 * slab.vertices[t[0]] + 0.7 * slab.vertices[t[1]]);
    flat.triangles.insert(flat.triangles.begin(), {t[0], t[1], static_cast<int>(flat.vertices.size()) - 1});
  }
  for (const double height : {0.0007, 1e-5, -1e-5, -0.0007}) {
    const TriMesh over = box({-0.06, 0.03 + height, -0.012}, {0.013, 0.05, 0.05});  // across an edge and a corner
    const auto clean = twoMeshes(over, slab).find(0.001), dirty = twoMeshes(over, flat).find(0.001);
    ASSERT_FALSE(clean.empty());
    ASSERT_EQ(clean.size(), dirty.size()) << height;
    const auto gaps = [](const std::vector<Proximity>& contacts) {
      std::multiset<long> set;
      for (const Proximity& c : contacts) set.insert(std::lround(1e9 * (c.gap + 0.1 * c.normal_W.y())));
      return set;
    };
    EXPECT_EQ(gaps(clean), gaps(dirty)) << height;
  }
}

}  // namespace
}  // namespace glenoid
