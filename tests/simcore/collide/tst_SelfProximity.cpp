// SPDX-License-Identifier: GPL-3.0-or-later
// A surface against itself: what two surfaces give is what one gives that consists of both, and a surface as it was made
// gives nothing.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "simcore/collide/Penetration.h"
#include "simcore/collide/SelfRest.h"
#include "tests/simcore/collide/Scene.h"

namespace glenoid {
namespace {

TriMesh joined(const TriMesh& a, const TriMesh& b) {
  TriMesh mesh = a;
  const int first = static_cast<int>(a.vertices.size());
  mesh.vertices.insert(mesh.vertices.end(), b.vertices.begin(), b.vertices.end());
  for (const auto& [i, j, k] : b.triangles) mesh.triangles.push_back({first + i, first + j, first + k});
  return mesh;
}

TriMesh moved(TriMesh mesh, const Vec3& by, const Mat3& turn = Mat3::Identity()) {
  for (Vec3& x : mesh.vertices) x = turn * x + by;
  return mesh;
}

/// Both bodies in one surface that was made with them far apart.
struct Both {
  std::shared_ptr<const CollisionSurface> surface;
  std::vector<Vec3> x;

  Both(const TriMesh& a, const TriMesh& b) : surface(makeCollisionSurface(joined(a, moved(b, Vec3(5, 0, 0))))), x(joined(a, b).vertices) {}
  std::vector<Proximity> find(double distance) const {
    ProximityFinder finder({surface}, {{0, 0, {}, {}}});
    const std::span<const Vec3> spans[] = {x};
    return finder.find(spans, {}, distance, 0.005);
  }
  double depth() const {
    const std::span<const Vec3> spans[] = {x};
    return PenetrationCheck({surface}, {{0, 0, {}, {}}}).deepest(spans).depth;
  }
};

/// Contacts by gap, and by direction without a sign: which of two features is called the first differs.
std::vector<std::array<double, 4>> listed(const std::vector<Proximity>& found) {
  std::vector<std::array<double, 4>> list;
  for (const Proximity& p : found) list.push_back({p.gap, std::abs(p.normal_W.x()), std::abs(p.normal_W.y()), std::abs(p.normal_W.z())});
  for (auto& entry : list)
    for (double& value : entry) value = std::round(1e9 * value) / 1e9;
  std::sort(list.begin(), list.end());
  return list;
}

TEST(SelfProximity, findsWhatTwoSurfacesOfTheSameShapesFind) {
  shapes::Numbers random(7);
  int contacts = 0;
  for (int round = 0; round < 100; ++round) {
    const TriMesh a = shapes::box(Vec3(0, 0, 0), Vec3(0.02, 0.01, 0.02));
    const Mat3 turn = Eigen::AngleAxisd(0.3 * random.in(-1, 1), Vec3(random.in(-1, 1), random.in(-1, 1), random.in(-1, 1)).normalized()).toRotationMatrix();
    const TriMesh b = moved(round % 2 ? shapes::box(Vec3(-0.006, 0, -0.006), Vec3(0.006, 0.01, 0.006)) : shapes::sphere(Vec3(0, 0.006, 0), 0.006, 2),
                            Vec3(random.in(0, 0.02), 0.01 + 0.0008 * random.in(-1, 1), random.in(0, 0.02)), turn);
    const Both both(a, b);
    const auto self = both.find(0.001), pair = twoMeshes(a, b).find(0.001);
    contacts += static_cast<int>(pair.size());
    EXPECT_EQ(listed(self), listed(pair)) << "round " << round;
    // The check finds what the check of two surfaces finds, as long as neither body is thinner than that.
    CollisionScene scene = twoMeshes(a, b);
    const double deep = deepestPenetration(scene.surfaces(), scene.pairs, scene.positionSpans()).depth;
    if (deep < 0.003) EXPECT_NEAR(both.depth(), deep, 0.1 * deep + 1e-7) << "round " << round;
  }
  EXPECT_GT(contacts, 120);
}

TEST(SelfProximity, keysAreUniqueAndAscend) {
  const Both both(shapes::box(Vec3(0, 0, 0), Vec3(0.02, 0.01, 0.02)), shapes::box(Vec3(0, 0.0101, 0), Vec3(0.02, 0.02, 0.02)));
  const auto found = both.find(0.001);
  ASSERT_GT(found.size(), 3u);
  for (std::size_t i = 1; i < found.size(); ++i) EXPECT_LT(found[i - 1].key, found[i].key);
  for (const Proximity& p : found) EXPECT_NEAR(p.gap, 1e-4, 1e-12);
}

TEST(SelfProximity, aShapeAsItWasMadeMakesNoContact) {
  const TriMesh ball = shapes::sphere(Vec3::Zero(), 0.02, 3), plate = shapes::box(Vec3(0, 0, 0), Vec3(0.05, 0.0005, 0.05));
  // Two plates that were made 0.4 mm apart, and a ball as thin as an egg's shell is no thinner here.
  const TriMesh slit = joined(plate, moved(plate, Vec3(0, 0.0009, 0)));
  for (const TriMesh& mesh : {ball, plate, slit})
    for (const bool deforms : {false, true}) {
      ProximityFinder finder({makeCollisionSurface(mesh, deforms)}, {{0, 0, {}, {}}});
      const std::span<const Vec3> spans[] = {mesh.vertices};
      EXPECT_TRUE(finder.find(spans, {}, 0.0015, 0.005).empty());
      EXPECT_EQ(PenetrationCheck({makeCollisionSurface(mesh)}, {{0, 0, {}, {}}}).deepest(spans).depth, 0);
      // Pressed to half its thickness it is still one body.
      std::vector<Vec3> flat = mesh.vertices;
      for (Vec3& x : flat) x.y() *= 0.5;
      const std::span<const Vec3> pressed[] = {flat};
      if (&mesh != &slit)
        for (const Proximity& p : finder.find(pressed, {}, 0.0015, 0.005)) EXPECT_GE(p.gap, 0) << "it is not inside itself";
    }
}

TEST(SelfProximity, flatAndRoundPiecesCostNoTests) {
  const TriMesh ball = shapes::sphere(Vec3::Zero(), 0.02, 4);  // 2048 triangles
  ProximityFinder finder({makeCollisionSurface(ball, true)}, {{0, 0, {}, {}}});
  const std::span<const Vec3> spans[] = {ball.vertices};
  finder.find(spans, {}, 0.0015, 0.005);
  EXPECT_EQ(finder.counts().trianglePairs, 0);
}

TEST(SelfProximity, restTellsAirFromBody) {
  // A plate: its two sides have body between them. Two plates: what looks across the slit has air.
  const TriMesh plate = shapes::box(Vec3(0, 0, 0), Vec3(0.05, 0.002, 0.05));
  const auto surface = makeCollisionSurface(joined(plate, moved(plate, Vec3(0, 0.003, 0))));
  const SelfRest rest(surface, {});
  const auto triangleAt = [&](double y, double up) {
    for (int t = 0; t < static_cast<int>(surface->triangles.size()); ++t) {
      const auto [i, j, k] = surface->triangles[t];
      const auto& x = surface->restVertices;
      const Vec3 n = (x[j] - x[i]).cross(x[k] - x[i]);
      if (n.y() * up > 0 && std::abs(x[i].y() - y) + std::abs(x[j].y() - y) + std::abs(x[k].y() - y) < 1e-9) return t;
    }
    return -1;
  };
  const int topOfLower = triangleAt(0.002, 1), bottomOfUpper = triangleAt(0.003, -1), bottomOfLower = triangleAt(0, -1);
  int corner = -1;  // of the lower plate's upper side
  for (int v = 0; v < 8; ++v)
    if (surface->restVertices[v].y() > 0.001) corner = v;
  const auto across = rest.vertexAndTriangle(corner, bottomOfUpper), through = rest.vertexAndTriangle(corner, bottomOfLower);
  EXPECT_NEAR(across.distance, 0.001, 1e-12);
  EXPECT_TRUE(across.facing);
  EXPECT_NEAR(through.distance, 0.002, 1e-12);
  EXPECT_FALSE(through.facing);
  EXPECT_TRUE(SelfRest::cameFromOutside(across, 0.01));
  EXPECT_FALSE(SelfRest::cameFromOutside(through, 0.002));
  EXPECT_TRUE(SelfRest::cameFromOutside(through, 0.0004));
  EXPECT_LT(SelfRest::contactDistance(0.0015, across), 0.001);
  EXPECT_EQ(SelfRest::contactDistance(0.0005, across), 0.0005);
  EXPECT_TRUE(rest.share(corner, topOfLower) || topOfLower >= 0);
}

}  // namespace
}  // namespace glenoid
