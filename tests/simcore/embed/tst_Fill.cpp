// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/embed/Fill.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

#include "simcore/embed/Cells.h"
#include "simcore/mesh/TetTools.h"
#include "tests/simcore/mesh/Shapes.h"

using namespace glenoid;

namespace {

double filled(const TetMesh& mesh, const std::vector<double>& fill) {
  double sum = 0;
  for (std::size_t i = 0; i < fill.size(); ++i) sum += fill[i] * tetVolume(mesh, static_cast<int>(i));
  return sum;
}

}  // namespace

TEST(Fill, boxCutsOneTetrahedronInHalf) {
  // Corner tetrahedron of the unit cube; the box takes x < c: its volume is (1 − (1 − c)³)/6.
  const TetMesh mesh{{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}, {{0, 1, 2, 3}}};
  for (const double c : {0.1, 0.5, 0.9}) {
    const TriMesh box = shapes::box(Vec3(-1, -1, -1), Vec3(c, 2, 2));
    EXPECT_NEAR(enclosedVolumes(mesh, box)[0], (1 - std::pow(1 - c, 3)) / 6, 1e-14);
    // The same cut along the direction in which the prisms run.
    const TriMesh flat = shapes::box(Vec3(-1, -1, -1), Vec3(2, 2, c));
    EXPECT_NEAR(enclosedVolumes(mesh, flat)[0], (1 - std::pow(1 - c, 3)) / 6, 1e-14);
  }
  EXPECT_EQ(fillFractions(mesh, shapes::box(Vec3::Constant(-1), Vec3::Constant(2))),
            std::vector<double>{1.0});
}

TEST(Fill, partsAddUpToTheEnclosedVolume) {
  Pose oblique;
  oblique.q_WB = Quat(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()));
  for (const TriMesh& shape :
       {shapes::sphere(0.02), shapes::moved(shapes::torus(0.016, 0.003, 60, 14), oblique),
        shapes::moved(shapes::sheet(0.034, 0.02, 0.0014, 0.4), oblique)}) {
    const TetMesh mesh = embedInCells(shape, shape, 0.006).value();
    const std::vector<double> parts = enclosedVolumes(mesh, shape), fill = fillFractions(mesh, shape);
    const double volume = enclosedVolume(shape);
    // Some thousand clips, each exact to round-off of the part's own size.
    EXPECT_NEAR(std::accumulate(parts.begin(), parts.end(), 0.0) / volume, 1, 1e-9);
    EXPECT_NEAR(filled(mesh, fill) / volume, 1, 1e-9);
    for (std::size_t i = 0; i < parts.size(); ++i) {
      EXPECT_GE(parts[i], -1e-9 * volume);
      EXPECT_LE(parts[i] / tetVolume(mesh, static_cast<int>(i)), 1 + 1e-9);
      EXPECT_GE(fill[i], kFillFloor);
      EXPECT_LE(fill[i], 1);
    }
  }
}

TEST(Fill, momentsOfACutTetrahedronAreThoseOfItsPieces) {
  // The corner tetrahedron of the unit cube cut at x = c loses the one at (1, 0, 0), shrunk by s = 1 − c. Its λ are
  // λ_1 = c + s µ_1 and s µ_i; ∫ µ_i µ_j = V (1 + δ_ij)/20 with V = s³/6.
  const TetMesh mesh{{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}, {{0, 1, 2, 3}}};
  const Eigen::Matrix4d even = (Eigen::Matrix4d::Ones() + Eigen::Matrix4d::Identity()) / 20;
  for (const double c : {0.1, 0.5, 0.9}) {
    const double s = 1 - c, volume = s * s * s / 6;
    Eigen::Matrix4d to = s * Eigen::Matrix4d::Identity();  // λ = to µ, since Σ µ = 1
    to.row(1) += c * Vec4::Ones().transpose();
    const Eigen::Matrix4d wanted = even / 6 - volume * to * even * to.transpose();
    const Eigen::Matrix4d found = enclosedMoments(mesh, shapes::box(Vec3(-1, -1, -1), Vec3(c, 2, 2)))[0];
    EXPECT_LT((found - wanted).norm(), 1e-15) << c;
    EXPECT_NEAR(found.sum(), enclosedVolumes(mesh, shapes::box(Vec3(-1, -1, -1), Vec3(c, 2, 2)))[0], 1e-15);
  }
}

TEST(Fill, agreesWithCounting) {
  // Independent of the clipping: points of a fine regular lattice in barycentric coordinates, inside the ball
  // that has the facets' volume.
  const TriMesh ball = shapes::sphere(1.0, 96, 63);
  const double radius = std::cbrt(enclosedVolume(ball) * 3 / (4 * M_PI));
  const TetMesh mesh{{Vec3(-0.2, -0.3, 0.1), Vec3(1.4, 0.1, 0.2), Vec3(0.2, 1.3, 0.3), Vec3(0.1, 0.2, 1.5)},
                     {{0, 1, 2, 3}}};
  const int n = 120;
  int all = 0, inside = 0;
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      for (int k = 0; k < n; ++k) {
        const Vec3 w = Vec3(i + 0.5, j + 0.5, k + 0.5) / n;
        if (w.sum() >= 1) continue;
        const Vec3 p = (1 - w.sum()) * mesh.nodes[0] + w[0] * mesh.nodes[1] + w[1] * mesh.nodes[2] +
                       w[2] * mesh.nodes[3];
        ++all, inside += p.norm() < radius;
      }
  // Counting a slanted boundary with 120 points along each edge is good to a small part of one per cent.
  EXPECT_NEAR(fillFractions(mesh, ball)[0], static_cast<double>(inside) / all, 0.003);
}

TEST(Fill, floorIsPaidByTheRest) {
  // Shifted so that a hundredth of the box reaches into a second cell.
  const TriMesh box = shapes::box(Vec3::Zero(), Vec3(0.0101, 0.01, 0.01));
  CellGrid grid;
  grid.cell = Vec3::Constant(0.01);
  grid.shift = Vec3(0.505, 0, 0);
  const TetMesh mesh = embedInCells(box, box, grid).value();
  const std::vector<double> fill = fillFractions(mesh, box);
  ASSERT_EQ(mesh.tets.size(), 10u);
  EXPECT_EQ(*std::min_element(fill.begin(), fill.end()), kFillFloor);
  EXPECT_NEAR(filled(mesh, fill) / enclosedVolume(box), 1, 1e-12);
}

TEST(Fill, nothingInsideLeavesTheFloor) {
  const TetMesh mesh{{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}, {{0, 1, 2, 3}}};
  EXPECT_EQ(fillFractions(mesh, shapes::box(Vec3::Constant(2), Vec3::Constant(3))),
            std::vector<double>{kFillFloor});
  EXPECT_TRUE(fillFractions(TetMesh{}, shapes::sphere(1)).empty());
}
