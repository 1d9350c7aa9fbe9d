// SPDX-License-Identifier: GPL-3.0-or-later
// Overlaps so deep that the nearest ways out of what has passed the other's middle lead further in.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "tests/simcore/collide/Scene.h"

namespace glenoid {
namespace {

using namespace shapes;

constexpr double kRadius = 0.02, kContact = 0.0015;  // m
constexpr ProximityLimits kNearestWays{1, 0.5, std::numeric_limits<double>::infinity()};

CollisionScene twoBalls(const Vec3& apart, int fineness = 3) {
  return twoMeshes(sphere(Vec3::Zero(), kRadius, fineness), moved(sphere(Vec3::Zero(), kRadius, fineness), poseOf(apart, {1, 2, 3}, 0.4)));
}

int wrongWay(const std::vector<Proximity>& contacts, const Vec3& out) {
  int count = 0;
  for (const Proximity& c : contacts) count += c.normal_W.dot(out) <= 0;
  return count;
}

TEST(DeepOverlap, ballsPastEachOthersMiddleLeaveAlongTheLineOfTheirCentres) {
  for (const double distance : {0.25, 0.5, 0.8})
    for (const Vec3& way : {Vec3(1, 0, 0), Vec3(-2, 1, 0.5), Vec3(0.1, -0.2, 1)}) {
      const Vec3 out = -way.normalized();  // of the first, out of the second
      const CollisionScene scene = twoBalls(-distance * kRadius * out);
      const auto contacts = scene.find(kContact);
      int deep = 0;
      for (const Proximity& c : contacts) {
        if (c.gap >= 0) continue;
        ++deep;
        // By symmetry, but for the mesh: facets are 0.14 rad wide, and less than half of one is left on the whole.
        EXPECT_GT(c.normal_W.dot(out), std::cos(0.06)) << distance;
        // The point of the other surface lies that far along the normal.
        const Vec3 between = scene.at(0, c.a) - scene.at(1, c.b);
        EXPECT_LT((between - c.gap * c.normal_W).norm(), 1e-6);
        // A chord of the other ball, facets within it by 1 − cos of half of them.
        const bool first = c.a.count == 1 && c.b.count > 1;
        const Vec3 p = first ? scene.at(0, c.a) : scene.at(1, c.b), centre = first ? Vec3(-distance * kRadius * out) : Vec3(Vec3::Zero());
        const Vec3 along = first ? c.normal_W : Vec3(-c.normal_W), r = p - centre;
        const double chord = -r.dot(along) + std::sqrt(std::pow(r.dot(along), 2) + kRadius * kRadius - r.squaredNorm());
        EXPECT_NEAR(-c.gap, chord, 0.08 * kRadius);
      }
      EXPECT_GT(deep, 4);
      EXPECT_EQ(wrongWay(contacts, out), 0);
    }
}

TEST(DeepOverlap, whatOverlapsLessKeepsItsNearestWays) {
  // Each other's middles are not reached.
  const CollisionScene scene = twoBalls(Vec3(1.1 * kRadius, 0, 0));
  const auto found = scene.find(kContact), nearest = scene.find(kContact, 0.005, kNearestWays);
  ASSERT_GT(found.size(), 10u);
  ASSERT_EQ(found.size(), nearest.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i].normal_W, nearest[i].normal_W);
}

TEST(DeepOverlap, turnsWithTheScene) {
  CollisionScene scene = twoBalls(Vec3(0.008, 0.004, -0.003));
  const auto contacts = scene.find(kContact);
  const Pose turn = poseOf({0.3, -0.1, 0.2}, {3, -1, 2}, 1.1);
  for (TriMesh& mesh : scene.meshes) mesh = moved(mesh, turn);
  const auto turned = scene.find(kContact);
  ASSERT_EQ(contacts.size(), turned.size());
  for (std::size_t i = 0; i < contacts.size(); ++i) {
    EXPECT_EQ(contacts[i].key, turned[i].key);
    EXPECT_NEAR(contacts[i].gap, turned[i].gap, 1e-12);
    EXPECT_LT((turn.q_WB * contacts[i].normal_W - turned[i].normal_W).norm(), 1e-9);
  }
}

TEST(DeepOverlap, aShellWrappedCloselyRoundABallIsNotDeep) {
  // Half a shell of 3 mm lies 0.4 mm in the ball all round: normals look every way, and each is right.
  TriMesh shell = sphere(Vec3::Zero(), kRadius - 0.0004, 3);
  // Inner and outer half spheres joined at their rims.
  TriMesh half;
  const int count = static_cast<int>(shell.vertices.size());
  half.vertices = shell.vertices;
  for (const Vec3& v : shell.vertices) half.vertices.push_back(v * (kRadius + 0.003) / v.norm());
  std::map<std::array<int, 2>, int> rim;
  for (const auto& t : shell.triangles) {
    if (shell.vertices[t[0]].y() < -1e-9 || shell.vertices[t[1]].y() < -1e-9 || shell.vertices[t[2]].y() < -1e-9) continue;
    half.triangles.push_back({t[0], t[2], t[1]});
    half.triangles.push_back({t[0] + count, t[1] + count, t[2] + count});
    for (int k = 0; k < 3; ++k) {
      const int i = t[k], j = t[(k + 1) % 3];
      if (!rim.erase({j, i})) rim[{i, j}] = 1;
    }
  }
  for (const auto& [edge, one] : rim) {
    half.triangles.push_back({edge[0], edge[1], edge[1] + count});
    half.triangles.push_back({edge[0], edge[1] + count, edge[0] + count});
  }
  ASSERT_GT(enclosedVolume(half), 0);
  const CollisionScene scene = twoMeshes(half, sphere(Vec3::Zero(), kRadius, 3));
  const auto found = scene.find(kContact), nearest = scene.find(kContact, 0.005, kNearestWays);
  ASSERT_GT(found.size(), 20u);
  ASSERT_EQ(found.size(), nearest.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i].normal_W, nearest[i].normal_W);
}

TEST(DeepOverlap, rowsFollowTheSizeOfTheOverlapAndNotTheTriangles) {
  for (const int fineness : {2, 3, 4}) {
    std::size_t deep = 0;
    for (const Proximity& c : twoBalls(Vec3(0.5 * kRadius, 0, 0), fineness).find(kContact)) deep += c.gap < 0;
    EXPECT_GE(deep, 4u);
    // Bins of a third of a radius across a disk.
    EXPECT_LT(deep, 60u) << fineness;
  }
}

TEST(DeepOverlap, swappedSurfacesGiveTheOppositeNormal) {
  CollisionScene scene = twoBalls(Vec3(0.008, 0.004, -0.003));
  const auto contacts = scene.find(kContact);
  std::swap(scene.meshes[0], scene.meshes[1]);
  const auto swapped = scene.find(kContact);
  ASSERT_EQ(contacts.size(), swapped.size());
  ASSERT_FALSE(contacts.empty());
  std::multiset<double> gaps, others;
  for (const Proximity& c : contacts) gaps.insert(c.gap);
  for (const Proximity& c : swapped) others.insert(c.gap);
  for (auto i = gaps.begin(), j = others.begin(); i != gaps.end(); ++i, ++j) EXPECT_NEAR(*i, *j, 1e-12);
  EXPECT_NEAR((contacts[0].normal_W + swapped[0].normal_W).norm(), 0, 1e-12);
}

TEST(DeepOverlap, whatIsGluedIsNotPartedByIt) {
  // All of the second ball near the overlap is a coupling region: nothing there is pushed.
  CollisionScene scene = twoBalls(Vec3(0.5 * kRadius, 0, 0));
  const TriMesh& second = scene.meshes[1];
  std::vector<char> skip(second.triangles.size(), 0);
  for (std::size_t t = 0; t < skip.size(); ++t) skip[t] = second.vertices[second.triangles[t][0]].x() < 0;
  scene.pairs[0].skipTriangleB = skip;
  const auto found = scene.find(kContact), nearest = scene.find(kContact, 0.005, kNearestWays);
  ASSERT_EQ(found.size(), nearest.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i].normal_W, nearest[i].normal_W);
}

TEST(DeepOverlap, aBarThroughABallHasNoSideToLeaveBy) {
  // As much of the bar looks one way as the other: the rows are those of nearest ways.
  const CollisionScene scene = twoMeshes(sphere(Vec3::Zero(), kRadius, 3), box({-0.08, -0.004, -0.004}, {0.08, 0.004, 0.004}));
  const auto found = scene.find(kContact), nearest = scene.find(kContact, 0.005, kNearestWays);
  ASSERT_FALSE(found.empty());
  ASSERT_EQ(found.size(), nearest.size());
  for (std::size_t i = 0; i < found.size(); ++i) EXPECT_EQ(found[i].normal_W, nearest[i].normal_W);
}

TEST(DeepOverlap, twoPlacesOfOnePairLeaveEachItsOwnWay) {
  // A bent clamp: a ball between two balls of one surface, deep in both, is pushed against both.
  TriMesh two = moved(sphere(Vec3::Zero(), kRadius, 3), poseOf({-0.6 * kRadius - 2 * kRadius, 0, 0}, {0, 1, 0}, 0));
  const TriMesh right = moved(sphere(Vec3::Zero(), kRadius, 3), poseOf({0.6 * kRadius + 2 * kRadius, 0, 0}, {0, 1, 0}, 0));
  const int base = static_cast<int>(two.vertices.size());
  two.vertices.insert(two.vertices.end(), right.vertices.begin(), right.vertices.end());
  for (const auto& t : right.triangles) two.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  // A dumbbell whose ends lie deep in the two.
  TriMesh dumbbell = moved(sphere(Vec3::Zero(), kRadius, 3), poseOf({-2.1 * kRadius, 0, 0}, {0, 1, 0}, 0));
  const TriMesh end = moved(sphere(Vec3::Zero(), kRadius, 3), poseOf({2.1 * kRadius, 0, 0}, {0, 1, 0}, 0));
  dumbbell.vertices.insert(dumbbell.vertices.end(), end.vertices.begin(), end.vertices.end());
  for (const auto& t : end.triangles) dumbbell.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
  int left = 0, rights = 0;
  const CollisionScene scene = twoMeshes(dumbbell, two);
  for (const Proximity& c : scene.find(kContact)) {
    if (c.gap >= 0) continue;
    const bool onLeft = scene.at(0, c.a).x() < 0;
    EXPECT_GT(c.normal_W.x() * (onLeft ? 1 : -1), 0.99);
    (onLeft ? left : rights) += 1;
  }
  EXPECT_GT(left, 3);
  EXPECT_GT(rights, 3);
}

}  // namespace
}  // namespace glenoid
