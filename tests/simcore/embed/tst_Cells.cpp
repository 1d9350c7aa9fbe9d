// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/embed/Cells.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <limits>

#include "simcore/embed/Bind.h"
#include "simcore/mesh/MeshHealth.h"
#include "simcore/mesh/Simplify.h"
#include "simcore/mesh/TetTools.h"
#include "tests/simcore/mesh/Shapes.h"

using namespace glenoid;

namespace {

/// Least barycentric weight of any vertex in the tetrahedron that holds it: negative outside.
double worstWeight(const TetMesh& mesh, const TriMesh& surface) {
  double worst = 1;
  for (const VertexBinding& b : bindToTets(mesh, surface.vertices))
    worst = std::min(worst, *std::min_element(b.weight.begin(), b.weight.end()));
  return worst;
}

}  // namespace

TEST(Cells, sphereIsCoveredByConformingPositiveTetrahedra) {
  const TriMesh ball = shapes::sphere(0.02);
  const TriMesh coarse = simplify(ball, 100).value();
  for (const double size : {0.03, 0.011, 0.005}) {
    const TetMesh mesh = embedInCells(ball, coarse, size).value();
    const TetHealth health = healthOf(mesh);
    EXPECT_TRUE(health.healthy());
    EXPECT_EQ(health.components, 1);
    EXPECT_GT(totalVolume(mesh), enclosedVolume(ball));
    // Five tetrahedra of a cube: the middle one regular, the corners 12·(1/2)^(2/3)/9.
    EXPECT_NEAR(qualityOf(mesh).min, 12 * std::cbrt(0.25) / 9, 1e-12);
    EXPECT_NEAR(qualityOf(mesh).max, 1, 1e-12);
    // Round-off of the cell's corners only.
    EXPECT_GT(worstWeight(mesh, ball), -1e-12);
    EXPECT_GT(worstWeight(mesh, coarse), -1e-12);
  }
}

TEST(Cells, everyKeptTetrahedronMeetsTheVolumeAndNoOtherDoes) {
  // A box in cells that it fills exactly: all five of each cell, none of the touching ones outside.
  const TriMesh box = shapes::box(Vec3(0.01, 0.02, -0.03), Vec3(0.04, 0.04, -0.01));
  const TetMesh mesh = embedInCells(box, box, 0.01).value();
  EXPECT_EQ(mesh.tets.size(), 5u * 3 * 2 * 2);
  EXPECT_NEAR(totalVolume(mesh), enclosedVolume(box), 1e-15);
  // Half a cell shifted, one more layer of each kind is met.
  CellGrid grid;
  grid.cell = Vec3::Constant(0.01);
  grid.shift = Vec3(0.5, 0, 0);
  const TetMesh shifted = embedInCells(box, box, grid).value();
  EXPECT_TRUE(healthOf(shifted).healthy());
  EXPECT_GT(worstWeight(shifted, box), -1e-12);
  EXPECT_GT(shifted.tets.size(), mesh.tets.size());
  EXPECT_LE(shifted.tets.size(), 5u * 4 * 2 * 2);
}

TEST(Cells, holeOfATorusStaysOpen) {
  const TriMesh ring = shapes::torus(0.02, 0.003, 64, 16);
  const TetMesh mesh = embedInCells(ring, ring, 0.004).value();
  EXPECT_TRUE(healthOf(mesh).healthy());
  const TriMesh skin = boundaryOf(mesh);
  const MeshHealth health = healthOf(skin);
  EXPECT_EQ(health.openEdges, 0);
  for (const auto& t : mesh.tets) {
    Vec3 centroid = Vec3::Zero();
    for (const int v : t) centroid += mesh.nodes[v] / 4;
    EXPECT_GT(std::hypot(centroid.x(), centroid.z()), 0.01);
  }
}

TEST(Cells, collisionSurfaceOutsideTheVisualIsCoveredToo) {
  const TriMesh small = shapes::sphere(0.01), big = shapes::sphere(0.02);
  const TetMesh both = embedInCells(small, big, 0.008).value();
  EXPECT_EQ(both, embedInCells(big, small, 0.008).value());
  EXPECT_GT(worstWeight(both, big), -1e-12);
}

TEST(Cells, chosenCellsReachTheTargets) {
  struct Case {
    const char* name;
    TriMesh visual;
    int collision, target;
    GridAxes axes;
  };
  // Sizes and numbers like those of the paper's Table 1, lying obliquely.
  Pose oblique;
  oblique.q_WB = Quat(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()));
  oblique.p_WB = Vec3(0.01, 0.03, -0.02);
  const std::vector<Case> cases{
      {"muscle", shapes::moved(shapes::capsule(0.012, 0.09), oblique), 86, 87, GridAxes::World},
      {"broad muscle", shapes::moved(shapes::sheet(0.12, 0.08, 0.02, 0.8, 40, 30), oblique), 100, 158,
       GridAxes::World},
      {"ligament", shapes::moved(shapes::sheet(0.034, 0.02, 0.0014, 0.4), oblique), 146, 65, GridAxes::World},
      {"ligament, own axes", shapes::moved(shapes::sheet(0.034, 0.02, 0.0014, 0.4), oblique), 146, 65,
       GridAxes::Principal},
      {"labrum", shapes::moved(shapes::torus(0.016, 0.002, 53, 6), oblique), 120, 96, GridAxes::World},
      {"ball", shapes::sphere(0.02), 100, 122, GridAxes::World},
  };
  for (const Case& c : cases) {
    SCOPED_TRACE(c.name);
    const TriMesh coarse = simplify(c.visual, c.collision).value();
    const auto choice = chooseCells(c.visual, coarse, c.target, c.axes);
    ASSERT_TRUE(choice.ok()) << toLogLine(choice.error());
    const int count = static_cast<int>(choice->mesh.tets.size());
    if (std::getenv("GLENOID_PRINT"))
      std::printf("%s: %d of %d, cell %.2f mm, nodes %zu, fill %.2f\n", c.name, count, c.target,
                  1e3 * choice->cellSize, choice->mesh.nodes.size(),
                  enclosedVolume(c.visual) / totalVolume(choice->mesh));
    EXPECT_NEAR(count, c.target, 0.05 * c.target);
    EXPECT_TRUE(healthOf(choice->mesh).healthy());
    EXPECT_EQ(healthOf(choice->mesh).components, 1);
    EXPECT_GT(worstWeight(choice->mesh, c.visual), -1e-12);
    EXPECT_EQ(choice->mesh, embedInCells(c.visual, coarse, choice->grid).value());
  }
}

TEST(Cells, principalAxesAreRightHandedAndLongestFirst) {
  Pose turn;
  turn.q_WB = Quat(Eigen::AngleAxisd(0.4, Vec3(0.3, -0.5, 0.8).normalized()));
  const TriMesh box = shapes::moved(shapes::box(Vec3(-0.01, -0.02, -0.005), Vec3(0.01, 0.02, 0.005)), turn);
  const Mat3 axes = principalAxes(box).toRotationMatrix();
  EXPECT_NEAR(axes.determinant(), 1, 1e-12);
  EXPECT_NEAR(std::abs(axes.col(0).dot(turn.q_WB * Vec3::UnitY())), 1, 1e-9);
  EXPECT_NEAR(std::abs(axes.col(1).dot(turn.q_WB * Vec3::UnitX())), 1, 1e-9);
}

TEST(Cells, badInputIsRefused) {
  const TriMesh ball = shapes::sphere(0.02);
  EXPECT_EQ(embedInCells(ball, ball, 0).error().fault, Fault::OutOfRange);
  EXPECT_EQ(embedInCells(ball, ball, std::numeric_limits<double>::quiet_NaN()).error().fault,
            Fault::OutOfRange);
  EXPECT_EQ(embedInCells(ball, ball, 1e-6).error().fault, Fault::OutOfRange);
  EXPECT_EQ(embedInCells(ball, ball, 1e-300).error().fault, Fault::OutOfRange);
  TriMesh open = ball;
  open.triangles.pop_back();
  EXPECT_EQ(embedInCells(open, ball, 0.01).error().fault, Fault::MeshNotClosed);
  EXPECT_EQ(embedInCells(ball, open, 0.01).error().fault, Fault::MeshNotClosed);
  EXPECT_EQ(chooseCells(ball, ball, 0).error().fault, Fault::OutOfRange);
  TriMesh two = ball;  // far apart: no small cells join them
  for (const Vec3& v : ball.vertices) two.vertices.push_back(v + Vec3(1, 0, 0));
  const int n = static_cast<int>(ball.vertices.size());
  for (const auto& t : ball.triangles) two.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
  EXPECT_EQ(chooseCells(two, two, 300).error().fault, Fault::Unusable);
}
