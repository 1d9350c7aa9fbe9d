// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/author/MakeBody.h"

#include <gtest/gtest.h>

#include "simcore/mesh/MeshHealth.h"
#include "simcore/mesh/TetTools.h"
#include "tests/simcore/mesh/Shapes.h"

namespace glenoid {
namespace {

Part ball() {
  Part part;
  part.id = "ball";
  part.visual = std::make_shared<TriMesh>(shapes::sphere(0.02, 60, 30));
  part.collision = part.visual;
  return part;
}

TEST(MakeBody, softFiguresAreThoseOfTheMeshes) {
  const Part part = ball();
  BodyWish wish{PartKind::Soft, 300, 0.006};
  const auto body = makeBody(part, wish);
  ASSERT_TRUE(body.ok());
  const BodyFigures& figures = body->figures;
  EXPECT_NEAR(figures.collisionTriangles, 300, 15);
  EXPECT_EQ(figures.tetrahedra, static_cast<int>(body->volume->tets.size()));
  EXPECT_EQ(figures.nodes, static_cast<int>(body->volume->nodes.size()));
  EXPECT_EQ(figures.pieces, 1);
  // A sphere of 300 triangles: sagitta about r·θ²/8 with edges of θ ≈ 0.3 rad.
  EXPECT_GT(figures.deviationMax, 0.02 * 0.3 * 0.3 / 32);
  EXPECT_LT(figures.deviationMax, 0.02 * 0.3 * 0.3 / 3);
  EXPECT_LT(figures.deviationMean, figures.deviationMax);
  EXPECT_LT(std::abs(figures.volumeError), 1e-6) << "simplify keeps the volume";
  EXPECT_NEAR(figures.meanFill, enclosedVolume(*part.visual) / totalVolume(*body->volume), 1e-9);
  EXPECT_GT(figures.leastFill, -1e-12);
  EXPECT_LT(figures.leastFill, figures.meanFill);
  EXPECT_NEAR(figures.thinnest, 2.0 / 3 * 0.02, 2e-4) << "2 V / A of a sphere";
}

TEST(MakeBody, rigidHasNoVolumeAndTheVisualMayCollide) {
  const Part part = ball();
  const auto same = makeBody(part, {PartKind::Rigid, 0});
  ASSERT_TRUE(same.ok());
  EXPECT_EQ(same->collision, part.visual);
  EXPECT_EQ(same->volume, nullptr);
  EXPECT_EQ(same->figures.deviationMax, 0);
  BodyWish again{PartKind::Rigid, 300};
  const auto first = makeBody(part, again);
  again.collision = first->collision;
  EXPECT_EQ(makeBody(part, again)->collision, first->collision) << "made before, taken as it is";
}

TEST(MakeBody, saysWhyNot) {
  Part part = ball();
  EXPECT_EQ(makeBody(part, {PartKind::Soft, 300, 0}).error().fault, Fault::OutOfRange);
  EXPECT_EQ(makeBody(part, {PartKind::Rigid, 2}).error().fault, Fault::OutOfRange);
  EXPECT_EQ(makeBody(part, {PartKind::Rigid, 300}, [] { return true; }).error().fault, Fault::Cancelled);
  TriMesh open = *part.visual;
  open.triangles.pop_back();
  part.visual = std::make_shared<TriMesh>(open);
  const auto result = makeBody(part, {PartKind::Rigid, 300});
  EXPECT_EQ(result.error().fault, Fault::MeshNotClosed);
  EXPECT_EQ(result.error().place.part, "ball");
  part.visual = nullptr;
  EXPECT_EQ(makeBody(part, {PartKind::Rigid, 300}).error().fault, Fault::BadMesh);
}

TEST(WithBody, regionsGoToTheNewSurface) {
  Part part = ball();
  Region top{"top", "Top", "other", SurfaceKind::Collision, {}}, visual{"v", "V", "other", SurfaceKind::Visual, {{0, 3}}};
  std::vector<int> triangles;
  const TriMesh& mesh = *part.collision;
  for (int t = 0; t < static_cast<int>(mesh.triangles.size()); ++t)
    if (mesh.vertices[mesh.triangles[t][0]].z() > 0.01) triangles.push_back(t);
  top.triangles = runsOf(triangles);
  part.regions = {top, visual};
  const double before = areaOf(part, part.regions[0]);
  const BodyWish wish{PartKind::Soft, 400, 0.008};
  const auto body = makeBody(part, wish);
  ASSERT_TRUE(body.ok());
  const Part out = withBody(part, wish, *body);
  EXPECT_EQ(out.kind, PartKind::Soft);
  EXPECT_EQ(out.cellSize, 0.008);
  ASSERT_EQ(out.regions.size(), 2u);
  EXPECT_EQ(out.regions[1], visual);
  EXPECT_NEAR(areaOf(out, out.regions[0]) / before, 1, 0.15) << "to a ring of triangles";
  for (const int t : trianglesOf(out.regions[0])) ASSERT_LT(t, static_cast<int>(out.collision->triangles.size()));
}

TEST(ExpectedStep, growsWithTheTetrahedraAndMoreThanInProportion) {
  double last = 0, tets = 0;
  for (const double cell : {0.012, 0.008, 0.005}) {
    const auto body = makeBody(ball(), {PartKind::Soft, 300, cell});
    ASSERT_TRUE(body.ok());
    EXPECT_EQ(body->figures.stepMs, expectedStepMs(*body->volume));
    EXPECT_GT(body->figures.stepMs, last * body->figures.tetrahedra / std::max(tets, 1.0));
    last = body->figures.stepMs;
    tets = body->figures.tetrahedra;
  }
  EXPECT_EQ(makeBody(ball(), {PartKind::Rigid, 300})->figures.stepMs, 0);
}

}  // namespace
}  // namespace glenoid
