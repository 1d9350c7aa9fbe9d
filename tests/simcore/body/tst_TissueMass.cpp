// SPDX-License-Identifier: GPL-3.0-or-later
// Mass, mass centre and inertia of what the step moves, against integrals over the surface by the divergence theorem and
// against closed forms.
#include <gtest/gtest.h>

#include <Eigen/Cholesky>
#include <Eigen/LU>
#include <numbers>

#include "simcore/body/RigidObject.h"
#include "simcore/embed/Cells.h"
#include "simcore/embed/Fill.h"
#include "tests/scenes/BlockScenes.h"
#include "tests/simcore/body/SoftSystem.h"
#include "tests/simcore/mesh/Shapes.h"

namespace glenoid {
namespace {

constexpr double kDensity = 1100;

/// A shape in cells as a soft object, and its mass seen through its momenta under rigid motions.
struct Embedded {
  Embedded(const TriMesh& surface, const CellGrid& grid) : mesh(std::make_shared<TetMesh>(embedInCells(surface, surface, grid).value())) {
    const std::vector<Eigen::Matrix4d> moments = enclosedMoments(*mesh, surface);
    const std::vector<double> fill = fillFractions(*mesh, surface);
    std::vector<ElementTissue> tissue;
    for (std::size_t e = 0; e < fill.size(); ++e) tissue.push_back({lameFrom(5e4, 0.3), kDensity, 0, 0, fill[e], moments[e]});
    const int nodes = static_cast<int>(mesh->nodes.size());
    soft = SoftObject::make({false, true, 0, 3 * nodes, 0, 3 * nodes, nodes}, mesh, tissue, 0).value();
    q.resize(3 * nodes);
    for (int i = 0; i < nodes; ++i) q.segment<3>(3 * i) = mesh->nodes[i];
  }

  Vec6 momentumOf(const Vec3& velocity, const Vec3& omega, const Vec3& about) const {
    VecX v(q.size());
    for (Eigen::Index i = 0; i < q.size(); i += 3) v.segment<3>(i) = velocity + omega.cross(q.segment<3>(i) - about);
    return soft->momentumOf(q, v);
  }

  MassProperties properties() const {
    MassProperties read;
    read.mass = momentumOf(Vec3::UnitX(), Vec3::Zero(), Vec3::Zero()).x();
    // v = ω × x has the linear momentum m ω × c.
    const Vec3 x = momentumOf(Vec3::Zero(), Vec3::UnitX(), Vec3::Zero()).head<3>() / read.mass,
               y = momentumOf(Vec3::Zero(), Vec3::UnitY(), Vec3::Zero()).head<3>() / read.mass;
    read.centre = Vec3(-y.z(), x.z(), -x.y());
    for (int k = 0; k < 3; ++k) read.inertia.col(k) = momentumOf(Vec3::Zero(), Vec3::Unit(k), read.centre).tail<3>();
    return read;
  }

  std::shared_ptr<const TetMesh> mesh;
  std::unique_ptr<SoftObject> soft;
  VecX q;
};

CellGrid cubes(double size, const Vec3& shift = Vec3::Zero(), const Quat& frame = Quat::Identity()) {
  CellGrid grid;
  grid.cell = Vec3::Constant(size);
  grid.shift = shift;
  grid.frame.q_WB = frame;
  return grid;
}

Mat3 diagonal(double x, double y, double z) { return Vec3(x, y, z).asDiagonal(); }

TEST(TissueMass, isThatOfTheSurfaceForAnyCells) {
  Pose oblique;
  oblique.p_WB = Vec3(0.1, -0.2, 0.3);
  oblique.q_WB = Quat(Eigen::AngleAxisd(0.7, Vec3(1, 2, 3).normalized()));
  const Quat turned(Eigen::AngleAxisd(0.4, Vec3(3, -1, 1).normalized()));
  for (const TriMesh& shape : {shapes::sphere(0.02), shapes::moved(shapes::box(Vec3::Zero(), Vec3(0.05, 0.02, 0.011)), oblique),
                               shapes::moved(shapes::torus(0.016, 0.003, 60, 14), oblique),
                               shapes::moved(shapes::sheet(0.034, 0.02, 0.0014, 0.4), oblique)})
    for (const CellGrid& grid : {cubes(0.02), cubes(0.008, Vec3(0.3, 0.1, 0.7)), cubes(0.006, Vec3::Zero(), turned)}) {
      const MassProperties wanted = massPropertiesOf(shape, kDensity).value(), found = Embedded(shape, grid).properties();
      const double radius = std::sqrt(wanted.inertia.trace() / wanted.mass);
      // A millionth. What is left is the floor that keeps empty tetrahedra from having no mass.
      EXPECT_NEAR(found.mass / wanted.mass, 1, 1e-6);
      EXPECT_LT((found.centre - wanted.centre).norm(), 1e-6 * radius);
      EXPECT_LT((found.inertia - wanted.inertia).norm(), 1e-6 * wanted.inertia.norm());
    }
}

TEST(TissueMass, boxBarAndBallHaveTheirClosedForms) {
  // A bar one cell thick, beside cells it fills by half.
  const Vec3 size(0.08, 0.01, 0.006);
  const MassProperties bar = Embedded(shapes::box(-size / 2, size / 2), cubes(0.012)).properties();
  const double m = kDensity * size.prod();
  const Vec3 s2 = size.cwiseAbs2();
  EXPECT_NEAR(bar.mass / m, 1, 1e-6);
  EXPECT_LT(bar.centre.norm(), 1e-6 * size.norm());
  const Mat3 inertia = m / 12 * diagonal(s2.y() + s2.z(), s2.x() + s2.z(), s2.x() + s2.y());
  for (int k = 0; k < 3; ++k) EXPECT_NEAR(bar.inertia(k, k) / inertia(k, k), 1, 1e-6);

  // A cylinder of n sides and one of n rings: m = ρ h n/2 R² sin 2π/n, I about the axis m R²/6 (2 + cos 2π/n).
  const int sides = 12;
  const double R = 0.011, h = 0.03, angle = 2 * std::numbers::pi / sides;
  TriMesh prism = shapes::revolved([&](double s) { return Vec2(R, s < 0.5 ? -h / 2 : h / 2); }, -h / 2, h / 2, sides, 2);
  if (enclosedVolume(prism) < 0)
    for (auto& t : prism.triangles) std::swap(t[1], t[2]);
  const double prismMass = kDensity * h * sides / 2 * R * R * std::sin(angle), axial = prismMass * R * R / 6 * (2 + std::cos(angle));
  const MassProperties cylinder = Embedded(prism, cubes(0.008, Vec3(0.2, 0.6, 0.4))).properties();
  EXPECT_NEAR(cylinder.mass / prismMass, 1, 1e-6);
  EXPECT_LT(cylinder.centre.norm(), 1e-6 * h);
  EXPECT_LT((cylinder.inertia - diagonal(axial / 2 + prismMass * h * h / 12, axial, axial / 2 + prismMass * h * h / 12)).norm(), 1e-6 * axial);

  // The ball of the round formulas: what is left is its facets, which lose 2 % of it with 48 of them around.
  const double a = 0.02, ballMass = kDensity * 4 / 3 * std::numbers::pi * a * a * a;
  const double facets = enclosedVolume(shapes::sphere(a)) / (4 / 3.0 * std::numbers::pi * a * a * a);
  EXPECT_NEAR(facets, 1, 0.01);
  for (const double cell : {a, a / 2}) {
    const MassProperties ball = Embedded(shapes::sphere(a), cubes(cell)).properties();
    EXPECT_NEAR(ball.mass / (facets * ballMass), 1, 1e-6);
    const double scale = std::pow(facets, 5 / 3.0);  // of a ball that has the volume of the facets
    EXPECT_NEAR(ball.inertia.trace() / 3 / (0.4 * ballMass * a * a * scale), 1, 1e-3);
  }
}

TEST(TissueMass, matrixIsPositiveDefiniteThoughTetrahedraAreEmpty) {
  // The collision surface reaches where no tissue is.
  const TriMesh visual = shapes::sphere(0.02), collision = shapes::box(Vec3::Constant(-0.021), Vec3::Constant(0.021));
  const TetMesh mesh = embedInCells(visual, collision, 0.01).value();
  const std::vector<Eigen::Matrix4d> moments = enclosedMoments(mesh, visual);
  std::vector<ElementTissue> tissue;
  int empty = 0;
  for (const Eigen::Matrix4d& m : moments) {
    tissue.push_back({lameFrom(5e4, 0.3), kDensity, 0, 0, 1, m});
    empty += m.sum() < 1e-18;  // m³, beside cells of 1e-6
  }
  ASSERT_GT(empty, 8);
  const int nodes = static_cast<int>(mesh.nodes.size());
  const auto soft = SoftObject::make({false, true, 0, 3 * nodes, 0, 3 * nodes, nodes}, std::make_shared<TetMesh>(mesh), tissue, 0).value();
  // M by columns, from momenta of one node at a time.
  MatX M(nodes, nodes);
  VecX unit = VecX::Zero(3 * nodes), q = VecX::Zero(3 * nodes);
  for (int i = 0; i < nodes; ++i)
    for (int j = 0; j < nodes; ++j) {
      unit.setZero();
      unit[3 * i] = 1;
      q.setZero();
      q[3 * j + 1] = 1;  // angular momentum about z of a node at (0, 1, 0) is −p_x: what node j has of it
      M(j, i) = -soft->momentumOf(q, unit)[5];
    }
  EXPECT_LT((M - M.transpose()).norm(), 1e-14 * M.norm());
  EXPECT_EQ(Eigen::LLT<MatX>(M).info(), Eigen::Success);
}

}  // namespace
}  // namespace glenoid
