// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/embed/WholeCells.h"

#include <gtest/gtest.h>

#include "simcore/embed/Bind.h"
#include "simcore/embed/Cells.h"
#include "simcore/embed/Fill.h"
#include "simcore/mesh/TetTools.h"
#include "tests/simcore/mesh/Shapes.h"

using namespace glenoid;

namespace {

Pose oblique() {
  Pose pose;
  pose.p_WB = Vec3(0.1, -0.2, 0.3);
  pose.q_WB = Quat(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()));
  return pose;
}

/// Volume, first and second moments of the tissue in W, out of the cells.
struct Sums {
  double volume = 0;
  Vec3 first = Vec3::Zero();
  Mat3 second = Mat3::Zero();
};
Sums sumsOf(const CellMesh& cells) {
  Sums sums;
  for (std::size_t t = 0; t < cells.tissue.size(); ++t) {
    const CellBox& box = cells.boxes[t / 5];
    for (const BoxPoint& point : boxPoints(cells.tissue[t])) {
      const Vec3 xi(point.xi[0], point.xi[1], point.xi[2]);
      const Vec3 x = box.origin + 0.5 * box.axes * (xi + Vec3::Ones()).cwiseProduct(box.edges);
      sums.volume += point.weight, sums.first += point.weight * x, sums.second += point.weight * x * x.transpose();
    }
  }
  return sums;
}

/// The same by the divergence theorem.
Sums sumsOf(const TriMesh& surface) {
  Sums sums;
  for (const auto& t : surface.triangles) {
    const Vec3 a = surface.vertices[t[0]], b = surface.vertices[t[1]], c = surface.vertices[t[2]], all = a + b + c;
    const double v = a.dot(b.cross(c)) / 6;
    sums.volume += v, sums.first += v / 4 * all;
    sums.second += v / 20 * (a * a.transpose() + b * b.transpose() + c * c.transpose() + all * all.transpose());
  }
  return sums;
}

}  // namespace

TEST(WholeCells, holdTheTissueOfTheSurfaceAndAreHealthy) {
  const Quat turned(Eigen::AngleAxisd(0.4, Vec3(3, -1, 1).normalized()));
  for (const TriMesh& shape : {shapes::sphere(0.02), shapes::moved(shapes::torus(0.016, 0.003, 60, 14), oblique()),
                               shapes::moved(shapes::sheet(0.034, 0.02, 0.0014, 0.4), oblique())})
    for (const Quat& frame : {Quat(Quat::Identity()), turned}) {
      CellGrid grid;
      grid.cell = Vec3(0.006, 0.007, 0.0065);
      grid.shift = Vec3(0.3, 0.1, 0.7);
      grid.frame.q_WB = frame;
      const TetMesh cut = embedInCells(shape, shape, grid).value();
      const CellMesh cells = wholeCells(cut, shape).value();
      EXPECT_TRUE(healthOf(cells.mesh).healthy());
      EXPECT_EQ(cells.mesh.tets.size(), 5 * cells.boxes.size());
      EXPECT_LE(healthOf(cells.mesh).components, healthOf(cut).components);
      const Sums found = sumsOf(cells), wanted = sumsOf(shape);
      EXPECT_NEAR(found.volume / wanted.volume, 1, 1e-7);
      EXPECT_LT((found.first - wanted.first).norm(), 1e-7 * wanted.volume * 0.02);
      EXPECT_LT((found.second - wanted.second).norm(), 1e-7 * wanted.volume * 4e-4);
      for (std::size_t c = 0; c < cells.boxes.size(); ++c)
        for (int i = 0; i < 8; ++i) {
          const Vec3 xi = cells.boxes[c].coordinatesOf(cells.mesh.nodes[cells.corners[c][i]]);
          for (int k = 0; k < 3; ++k) EXPECT_NEAR(xi[k], i >> k & 1 ? 1 : -1, 1e-6);
        }
    }
}

TEST(WholeCells, momentsOfABoxInItsCellAreItsIntegrals) {
  // A box within one cell: ∫ ξᵃ ηᵇ ζᶜ is a product of three.
  const Vec3 low(0.001, 0.003, 0.002), high(0.006, 0.008, 0.0045);
  const TriMesh box = shapes::box(low, high);
  CellGrid grid;
  grid.cell = Vec3(0.01, 0.011, 0.012);
  const CellMesh cells = wholeCells(embedInCells(box, box, grid).value(), box).value();
  ASSERT_EQ(cells.boxes.size(), 1u);
  BoxMoments all;
  for (const BoxMoments& moments : cells.tissue) all += moments;
  const Vec3 a = cells.boxes[0].coordinatesOf(low), b = cells.boxes[0].coordinatesOf(high);
  for (int k = 0; k < 27; ++k) {
    double wanted = cells.boxes[0].edges.prod() / 8;
    for (int axis = 0, power = k; axis < 3; ++axis, power /= 3) {
      const int p = power % 3 + 1;
      wanted *= (std::pow(b[axis], p) - std::pow(a[axis], p)) / p;
    }
    EXPECT_NEAR(all.value[k], wanted, 1e-12 * all.value[0]) << k;
  }
}

TEST(WholeCells, aSliverGoesToItsNeighbourAndAnEmptyCellGoes) {
  // 10.1 mm of box in cells of 10 mm: a hundredth of the second cell; the collision surface reaches into a third.
  const TriMesh visual = shapes::box(Vec3::Zero(), Vec3(0.0101, 0.01, 0.01)), collision = shapes::box(Vec3::Zero(), Vec3(0.021, 0.01, 0.01));
  const TetMesh cut = embedInCells(visual, collision, 0.0099).value();
  const CellMesh cells = wholeCells(cut, visual).value();
  const CellMesh alone = wholeCells(embedInCells(visual, visual, 0.0101).value(), visual).value();
  EXPECT_EQ(alone.boxes.size(), 1u);
  EXPECT_LT(5 * cells.boxes.size(), cut.tets.size());
  for (std::size_t c = 0; c < cells.boxes.size(); ++c) {
    double share = 0;
    for (int five = 0; five < 5; ++five) share += cells.tissue[5 * c + five].volume() / cells.boxes[c].edges.prod();
    EXPECT_GT(share, 0.02);
  }
  EXPECT_NEAR(sumsOf(cells).volume / enclosedVolume(visual), 1, 1e-9);
  // Points beyond the cells go on as their nearest cell does.
  for (const VertexBinding& binding : bindToTets(cells.mesh, collision.vertices)) {
    double sum = 0;
    for (const double w : binding.weight) {
      sum += w;
      EXPECT_LT(std::abs(w), 3);
    }
    EXPECT_NEAR(sum, 1, 1e-12);
  }
}

TEST(WholeCells, gradedBoxesAreCellsAndOtherTetrahedraAreNot) {
  const TriMesh box = shapes::box(Vec3::Zero(), Vec3(0.03, 0.01, 0.01));
  CellGrid grid;
  grid.cell = Vec3(0.01, 0.01, 0.01);
  TetMesh mesh = embedInCells(box, box, grid).value();
  for (Vec3& node : mesh.nodes)
    if (node.x() > 0.015) node.x() += 0.004;  // planes further apart
  EXPECT_EQ(wholeCells(mesh, box).value().boxes.size(), 3u);
  mesh.nodes[3].y() += 0.001;
  EXPECT_EQ(wholeCells(mesh, box).error().fault, Fault::Unusable);
  const TetMesh needle{{Vec3::Zero(), Vec3::UnitX(), Vec3(0.3, 1, 0), Vec3(0.1, 0.2, 1)}, {{0, 1, 2, 3}}};
  EXPECT_EQ(wholeCells(needle, box).error().fault, Fault::Unusable);
  EXPECT_EQ(wholeCells(TetMesh{}, box).error().fault, Fault::Unusable);
}
