// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/render/SceneGeometry.h"

#include <gtest/gtest.h>

#include "editor/render/SceneRenderer.h"
#include "tests/editor/render/TestScene.h"

namespace glenoid::test {
namespace {

TEST(SceneGeometry, creasesAreSplitAndSmoothSurfacesAreNot) {
  const Model model = smallScene();
  const auto geometry = buildSceneGeometry(model);
  ASSERT_TRUE(geometry.ok()) << toLogLine(geometry.error());
  const SurfaceRanges& box = geometry->objects[kBox].visual;
  EXPECT_EQ(box.vertices.count, 24);  // three sides at each of eight corners
  EXPECT_EQ(box.meshVertices, 8);
  const SurfaceRanges& ball = geometry->objects[kBall].visual;
  EXPECT_EQ(ball.vertices.count, ball.meshVertices);
  EXPECT_EQ(box.edges.count, 2 * 18);  // twelve edges and six diagonals
  EXPECT_EQ(geometry->objects[kBall].tetEdges.count, 2 * 18);
  EXPECT_EQ(geometry->springs.count, 8);
}

TEST(SceneGeometry, trianglesKeepTheirOrderAndTheirCorners) {
  const Model model = smallScene();
  const auto geometry = buildSceneGeometry(model);
  ASSERT_TRUE(geometry.ok());
  for (std::size_t i = 0; i < model.objects.size(); ++i) {
    const TriMesh& mesh = *model.objects[i].visual.mesh;
    const SurfaceRanges& surface = geometry->objects[i].visual;
    ASSERT_EQ(surface.triangles.count, 3 * static_cast<int>(mesh.triangles.size()));
    for (int k = 0; k < surface.triangles.count; ++k) {
      const auto v = geometry->indices[surface.triangles.first + k];
      EXPECT_EQ(geometry->source[v], mesh.triangles[k / 3][k % 3]);
    }
  }
}

TEST(SceneGeometry, everyTriangleStandsInTheRingOfEachOfItsCorners) {
  const auto geometry = buildSceneGeometry(smallScene());
  ASSERT_TRUE(geometry.ok());
  const SurfaceRanges& ball = geometry->objects[kBall].visual;
  int entries = 0;
  for (int v = ball.vertices.first; v < ball.vertices.first + ball.vertices.count; ++v)
    entries += geometry->rings[v][1];
  EXPECT_EQ(entries, ball.triangles.count);
  for (int t = 0; t < ball.triangles.count; t += 3)
    for (int k = 0; k < 3; ++k) {
      const auto at = [&](int c) {
        return static_cast<std::int32_t>(geometry->indices[ball.triangles.first + t + c % 3]);
      };
      const auto& ring = geometry->rings[at(k)];
      const auto first = geometry->neighbours.begin() + ring[0];
      const std::array<std::int32_t, 2> wanted{at(k + 1), at(k + 2)};
      EXPECT_NE(std::find(first, first + ring[1], wanted), first + ring[1]);
    }
}

TEST(SceneGeometry, positionsFollowTheDefinition) {
  const Model model = smallScene();
  const auto geometry = buildSceneGeometry(model);
  const VecX q = movedState(model).q;
  for (std::size_t i = 0; i < model.objects.size(); ++i) {
    const SurfaceRanges& surface = geometry->objects[i].visual;
    for (int v = surface.vertices.first; v < surface.vertices.first + surface.vertices.count; ++v) {
      const auto& binding = model.objects[i].visual.vertices[geometry->source[v]];
      // Weights and offsets are kept as floats: 2⁻²⁴ of 0.1 m.
      EXPECT_LT(
          (positionOf(geometry->vertices[v], q) - expectedPosition(model.objects[i], binding, q)).norm(),
          5e-8);
    }
  }
}

TEST(SceneGeometry, anIndexOutsideIsNamed) {
  const auto faultOf = [](const Model& model) {
    const auto geometry = buildSceneGeometry(model);
    return geometry ? std::string("none")
                    : std::string(faultName(geometry.error().fault)) + " " + geometry.error().place.part;
  };
  Model model = smallScene();
  model.objects[kBall].layout.qOffset += 1000;
  EXPECT_EQ(faultOf(model), "BadIndex ball");
  model = smallScene();
  model.objects[kBox].visual.vertices.pop_back();
  EXPECT_EQ(faultOf(model), "BadIndex box");
  model = smallScene();
  TriMesh mesh = *model.objects[kSphere].visual.mesh;
  mesh.triangles[3][1] = -2;
  model.objects[kSphere].visual.mesh = std::make_shared<TriMesh>(mesh);
  EXPECT_EQ(faultOf(model), "BadIndex sphere");
  model = smallScene();
  model.springs[0].objectB = 17;
  EXPECT_EQ(faultOf(model), "BadIndex ");
  model = smallScene();
  model.joint.parts[0].regions[0].triangles[0].count = 1 << 30;
  EXPECT_EQ(faultOf(model), "BadIndex ball");
  EXPECT_EQ(faultOf(smallScene()), "none");
}

}  // namespace
}  // namespace glenoid::test
