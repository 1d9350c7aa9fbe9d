// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/render/Occlusion.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "editor/render/OcclusionJob.h"
#include "tests/editor/render/TestScene.h"

namespace glenoid::test {
namespace {

constexpr int kFloor = 0, kLid = 1, kAside = 2;
constexpr double kGap = 0.006;

SceneObject body(Model& model, const char* id, const TriMesh& mesh, const Vec3& at) {
  SceneObject object;
  object.id = object.name = id;
  object.layout = {true, true, static_cast<int>(model.start.q.size()), 7, 0, 6, 0};
  for (const Vec3& x : mesh.vertices) object.visual.vertices.push_back({{}, {}, x});
  object.visual.mesh = std::make_shared<TriMesh>(mesh);
  model.start.q.conservativeResize(model.start.q.size() + 7);
  model.start.q.tail<7>() << at, 0, 0, 0, 1;
  return object;
}

/// A flat floor of 200 by 200 mm, 1 mm thick, its middle vertex at the origin; a ball of 10 mm a gap above it; a far ball.
struct Scene {
  Model model;
  SceneGeometry geometry;
  int middle = -1, corner = -1;  ///< vertices of the floor's upper side
  Scene() {
    model.start.q.resize(0);
    TriMesh floor;
    constexpr int kSide = 21;
    for (int i = 0; i < kSide; ++i)
      for (int j = 0; j < kSide; ++j) floor.vertices.push_back(Vec3(0.01 * (i - 10), 0, 0.01 * (j - 10)));
    for (int i = 0; i + 1 < kSide; ++i)
      for (int j = 0; j + 1 < kSide; ++j) {
        const int a = i * kSide + j, b = a + 1, c = a + kSide, d = c + 1;
        floor.triangles.push_back({a, b, c});
        floor.triangles.push_back({b, d, c});
      }
    model.objects.push_back(body(model, "floor", floor, Vec3::Zero()));
    model.objects.push_back(body(model, "lid", sphereMesh(Vec3::Zero(), 0.01, 24), Vec3(0, 0.01 + kGap, 0)));
    model.objects.push_back(body(model, "aside", sphereMesh(Vec3::Zero(), 0.01, 12), Vec3(0, 0.5, 0)));
    auto built = buildSceneGeometry(model);
    EXPECT_TRUE(built.ok());
    geometry = *built;
    middle = geometry.objects[kFloor].visual.vertices.first + 10 * kSide + 10;
    corner = geometry.objects[kFloor].visual.vertices.first;
  }
  std::vector<float> shown(float lid) const { return {1, lid, 1}; }
};

Occlusion castOf(const Scene& scene, int threads) {
  const std::atomic<bool> never{false};
  return Occlusion(scene.geometry, scene.model.start.q, threads, never);
}

std::vector<float> opennessOf(const Scene& scene, const Occlusion& occlusion, const VecX& q, float lid) {
  return occlusion.openness(scene.geometry, occlusion.presence(scene.geometry, q, scene.shown(lid)));
}

TEST(Occlusion, aBallDarkensTheFloorBelowIt) {
  const Scene scene;
  const Occlusion occlusion = castOf(scene, 1);
  const std::vector<float> open = opennessOf(scene, occlusion, scene.model.start.q, 1);
  ASSERT_EQ(open.size(), scene.geometry.vertices.size());
  // Of the projected hemisphere the ball hides sin² of its half angle, 10 / 16; each ray counts by how near it ends:
  // the mean of 1 − d / reach over the cap, d from the law of cosines, by the midpoint rule.
  const double sine = 0.01 / (0.01 + kGap), distance = 0.01 + kGap;
  double hidden = 0;
  constexpr int kSteps = 2000;
  for (int i = 0; i < kSteps; ++i) {
    const double s2 = sine * sine * (i + 0.5) / kSteps, cosine = std::sqrt(1 - s2);
    const double d = distance * cosine - std::sqrt(0.01 * 0.01 - distance * distance * s2);
    hidden += (1 - d / kOcclusionReach) * sine * sine / kSteps;
  }
  // Smoothing takes half from neighbours 10 mm away, which see the ball too, at a slant: less than half, more than none.
  EXPECT_LT(open[scene.middle], 1 - 0.5 * hidden);
  EXPECT_GT(open[scene.middle], 1 - hidden - 0.02);
  EXPECT_FLOAT_EQ(open[scene.corner], 1);
  const Range lid = scene.geometry.objects[kLid].visual.vertices, aside = scene.geometry.objects[kAside].visual.vertices;
  EXPECT_GT(open[lid.first], 0.95) << "the top of the ball";
  EXPECT_LT(open[lid.first + lid.count - 1], 0.75) << "its lowest point looks at the floor";
  for (int v = aside.first; v < aside.first + aside.count; ++v) EXPECT_GT(open[v], 0.99);
}

TEST(Occlusion, aHiddenPartLeavesNoDarkPlace) {
  const Scene scene;
  const Occlusion occlusion = castOf(scene, 1);
  const std::vector<float> open = opennessOf(scene, occlusion, scene.model.start.q, 0);
  EXPECT_FLOAT_EQ(open[scene.middle], 1);
  const std::vector<float> whole = opennessOf(scene, occlusion, scene.model.start.q, 1),
                           half = opennessOf(scene, occlusion, scene.model.start.q, 0.5f);
  EXPECT_NEAR(1 - half[scene.middle], 0.5f * (1 - whole[scene.middle]), 1e-6) << "half as dense, half as dark";
}

TEST(Occlusion, whatMovesAwayTakesItsShadeAlong) {
  const Scene scene;
  const Occlusion occlusion = castOf(scene, 1);
  const int lid = scene.geometry.objects[kLid].layout.qOffset, floor = scene.geometry.objects[kFloor].layout.qOffset;
  VecX q = scene.model.start.q;
  const float there = opennessOf(scene, occlusion, q, 1)[scene.middle];
  q[lid] += 0.003;
  EXPECT_FLOAT_EQ(opennessOf(scene, occlusion, q, 1)[scene.middle], there) << "3 mm are not seen";
  q[lid] = 0.010;
  const float halfway = opennessOf(scene, occlusion, q, 1)[scene.middle];
  EXPECT_NEAR(1 - halfway, 0.5 * (1 - there), 1e-5);
  q[lid] = 0.020;
  EXPECT_FLOAT_EQ(opennessOf(scene, occlusion, q, 1)[scene.middle], 1);
  q[floor] = 0.020;
  EXPECT_FLOAT_EQ(opennessOf(scene, occlusion, q, 1)[scene.middle], there) << "both moved alike";
}

TEST(Occlusion, isTheSameForAnyNumberOfThreads) {
  const Scene scene;
  const std::vector<float> one = opennessOf(scene, castOf(scene, 1), scene.model.start.q, 1),
                           four = opennessOf(scene, castOf(scene, 4), scene.model.start.q, 1);
  EXPECT_EQ(one, four);
}

TEST(Occlusion, holdsUntilASurfaceMoves) {
  Scene scene;
  const Occlusion occlusion = castOf(scene, 2);
  EXPECT_TRUE(occlusion.holdsFor(scene.geometry, scene.model.start.q));
  VecX q = scene.model.start.q;
  q[scene.geometry.objects[kLid].layout.qOffset + 1] += 1e-4;
  EXPECT_FALSE(occlusion.holdsFor(scene.geometry, q));
  SceneGeometry flipped = scene.geometry;
  std::swap(flipped.indices[flipped.objects[kLid].visual.triangles.first],
            flipped.indices[flipped.objects[kLid].visual.triangles.first + 1]);
  EXPECT_FALSE(occlusion.holdsFor(flipped, scene.model.start.q));
  EXPECT_FALSE(Occlusion().holdsFor(scene.geometry, scene.model.start.q));
}

TEST(Occlusion, toolsCastNothing) {
  const Model model = smallScene();
  const auto geometry = buildSceneGeometry(model);
  ASSERT_TRUE(geometry.ok());
  const std::atomic<bool> never{false};
  const Occlusion occlusion(*geometry, model.start.q, 2, never);
  const std::vector<float> opacity(geometry->objects.size(), 1.0f);
  const std::vector<float> open = occlusion.openness(*geometry, occlusion.presence(*geometry, model.start.q, opacity));
  const Range tool = geometry->objects[kTool].visual.vertices;
  for (int v = tool.first; v < tool.first + tool.count; ++v) EXPECT_EQ(open[v], 1);
  EXPECT_GT(geometry->objects[kTool].shaft.radius, 0.0039f);
  EXPECT_LT(*std::min_element(open.begin(), open.end()), 0.9f) << "box and balls shade each other";
}

TEST(Occlusion, aJobAnswersOnceAndStopsForTheNext) {
  const Scene scene;
  OcclusionJob job;
  EXPECT_EQ(job.take(true), nullptr) << "nothing was started";
  job.start(scene.geometry, VecX::Constant(scene.model.start.q.size(), 0.5));
  job.start(scene.geometry, scene.model.start.q);
  EXPECT_TRUE(job.running());
  const auto answer = job.take(true);
  ASSERT_NE(answer, nullptr);
  EXPECT_TRUE(answer->holdsFor(scene.geometry, scene.model.start.q));
  EXPECT_FALSE(job.running());
  EXPECT_EQ(job.take(true), nullptr);
}

}  // namespace
}  // namespace glenoid::test
