// SPDX-License-Identifier: GPL-3.0-or-later
// A = M − Δt ∂F/∂v − Δt² (∂F/∂q) G and b = Δt F + (M − Δt ∂F/∂v) v₀ of each kind of object against
// differences of F and of the kinetic energy, at frozen rotations; besides, tension's stiffness against
// turning (simcore/fem/README.md).
#include <gtest/gtest.h>

#include <Eigen/LU>

#include <Eigen/Eigenvalues>
#include <random>

#include "simcore/body/RigidObject.h"
#include "tests/scenes/BlockScenes.h"
#include "tests/simcore/body/SoftSystem.h"

namespace glenoid {
namespace {

struct Shape {
  const char* name;
  double scaleZ;  ///< 1: random about rest, 0: flattened to a plane, −1: mirrored
  double jitter;  ///< m
};

/// Elements of about 7 mm, turned by more than two radians and far from their rest shape.
test::SoftSystem deformed(const Shape& shape) {
  test::SoftSystem system(
      std::make_shared<TetMesh>(scenes::boxVolume(Vec3::Zero(), Vec3(0.02, 0.015, 0.014), 2, 2, 2)),
      {lameFrom(5e4, 0.45), 1100, 0.7, 2e-3, 0.6});
  std::mt19937 random(17);
  std::uniform_real_distribution<double> uniform(-1, 1);
  const Mat3 turn = Eigen::AngleAxisd(2.2, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
  for (int node = 0; node < system.layout.nodeCount; ++node) {
    Vec3 x =
        system.mesh->nodes[node] + shape.jitter * Vec3(uniform(random), uniform(random), uniform(random));
    x.z() *= shape.scaleZ;
    system.state.q.segment<3>(3 * node) = turn * x + Vec3(0.1, -0.2, 0.05);
    system.state.v.segment<3>(3 * node) = Vec3(uniform(random), uniform(random), uniform(random));
  }
  return system;
}

/// Elastic force on all nodes at q with the rotations that the system holds, from CorotTet one by one.
VecX forceAtFrozenRotations(const test::SoftSystem& system, const VecX& q) {
  VecX force = VecX::Zero(q.size());
  for (std::size_t e = 0; e < system.mesh->tets.size(); ++e) {
    const auto& nodes = system.mesh->tets[e];
    Mat34 x0, x;
    for (int i = 0; i < 4; ++i) {
      x0.col(i) = system.mesh->nodes[nodes[i]];
      x.col(i) = q.segment<3>(3 * nodes[i]);
    }
    const CorotTet tet = makeCorotTet(x0, system.tissue.lame, system.tissue.fill).value();
    const Mat3 R = Quat(Eigen::Map<const Quat>(system.state.rotations.data() + 4 * e)).toRotationMatrix();
    const Mat34 f = elasticForce(tet, deformationGradient(tet, x), R);
    for (int i = 0; i < 4; ++i) force.segment<3>(3 * nodes[i]) += f.col(i);
  }
  return force;
}

/// −∂F/∂q. F is linear in q at frozen rotations, so central differences have no error but round-off.
MatX stiffnessByDifferences(const test::SoftSystem& system) {
  const double h = 1e-3;
  const Eigen::Index n = system.state.q.size();
  MatX K(n, n);
  for (Eigen::Index j = 0; j < n; ++j) {
    VecX plus = system.state.q, minus = plus;
    plus[j] += h;
    minus[j] -= h;
    K.col(j) = (forceAtFrozenRotations(system, minus) - forceAtFrozenRotations(system, plus)) / (2 * h);
  }
  return K;
}

/// Tension's part of every element, put together densely.
MatX tensionPart(const test::SoftSystem& system) {
  MatX K = MatX::Zero(system.state.q.size(), system.state.q.size());
  for (std::size_t e = 0; e < system.mesh->tets.size(); ++e) {
    const auto& nodes = system.mesh->tets[e];
    Mat34 x0, x;
    for (int i = 0; i < 4; ++i) {
      x0.col(i) = system.mesh->nodes[nodes[i]];
      x.col(i) = system.state.q.segment<3>(3 * nodes[i]);
    }
    const CorotTet tet = makeCorotTet(x0, system.tissue.lame, system.tissue.fill).value();
    const Mat3 R = Quat(Eigen::Map<const Quat>(system.state.rotations.data() + 4 * e)).toRotationMatrix();
    const Mat34 b = rotatedGradients(tet, R);
    const double t = tensionStiffness(tet, deformationGradient(tet, x), R);
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < 4; ++j)
        K.block<3, 3>(3 * nodes[i], 3 * nodes[j]) += tensionBlock(t, b.col(i), b.col(j));
  }
  return K;
}

/// M as the Hessian of the kinetic energy, exact for a quadratic: M_ij = E(e_i + e_j) − E(e_i) − E(e_j).
MatX massByDifferences(const ContactObject& object, State state) {
  const Eigen::Index n = state.v.size();
  const auto energy = [&](Eigen::Index i, Eigen::Index j) {
    state.v.setZero();
    state.v[i] += 1;
    if (j >= 0) state.v[j] += 1;
    return object.kineticEnergy(state);
  };
  VecX alone(n);
  for (Eigen::Index i = 0; i < n; ++i) alone[i] = energy(i, -1);
  MatX M(n, n);
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j) M(i, j) = energy(i, j) - alone[i] - alone[j];
  return M;
}

class SoftDerivatives : public testing::TestWithParam<Shape> {};

TEST_P(SoftDerivatives, matrixAndRightHandSideAreThoseOfTheForce) {
  test::SoftSystem system = deformed(GetParam());
  StepSettings settings;
  settings.dt = 7e-3;
  settings.gravity_W = Vec3(0.3, -9.81, 1);
  settings.stretchLaw = false;  // which tst_StretchedBody and tst_StretchLaw are about
  BlockMatrix A(system.symbolic);
  VecX b;
  system.assemble(settings, A, b);
  const MatX K = stiffnessByDifferences(system), M = massByDifferences(*system.soft, system.state);
  const double dt = settings.dt, alpha = system.tissue.massDamping, beta = system.tissue.stiffnessDamping;
  // F(q, v) = f(q) + M g − (α M + β K) v, Rayleigh's damping with the stiffness at frozen rotations.
  const MatX expectedA = M + dt * (alpha * M + beta * K) + dt * dt * (K + tensionPart(system));
  const VecX weight = M * settings.gravity_W.replicate(system.layout.nodeCount, 1);
  const VecX expectedB = dt * (forceAtFrozenRotations(system, system.state.q) + weight) + M * system.state.v;
  // Differences over 1 mm of positions of 0.2 m lose three digits of sixteen.
  EXPECT_LT((A.toDense() - expectedA).norm(), 1e-12 * expectedA.norm());
  // Coordinates of 0.2 m hold elements of 7 mm with a strain of 1e-15; f(q) has strains of order one.
  EXPECT_LT((b - expectedB).norm(), 1e-12 * expectedB.norm());
  EXPECT_LT((A.toDense() - A.toDense().transpose()).norm(), 1e-15 * expectedA.norm());
}

TEST_P(SoftDerivatives, matrixIsPositiveDefinite) {
  test::SoftSystem system = deformed(GetParam());
  BlockMatrix A(system.symbolic);
  VecX b;
  StepSettings settings;
  settings.dt = 0.1;
  system.assemble(settings, A, b);
  // M alone bounds the smallest eigenvalue from below: K is semi-definite in any shape.
  const MatX M = massByDifferences(*system.soft, system.state);
  EXPECT_GT(Eigen::SelfAdjointEigenSolver<MatX>(A.toDense()).eigenvalues()[0],
            (1 - 1e-6) * M.diagonal().minCoeff());
}

INSTANTIATE_TEST_SUITE_P(Shapes, SoftDerivatives,
                         testing::Values(Shape{"random", 1, 2e-3}, Shape{"scattered", 1, 2e-2},
                                         Shape{"flattened", 0, 1e-3}, Shape{"inverted", -1, 1e-3}),
                         [](const auto& shape) { return shape.param.name; });

State tumbling() {
  State state;
  state.q.resize(7);
  setPoseAt(state.q, 0, {Vec3(0.3, -0.1, 0.2), Quat(Eigen::AngleAxisd(1.1, Vec3(1, 2, -2).normalized()))});
  state.v.resize(6);
  state.v << 0.3, -0.2, 0.5, 3.0, -2.0, 4.0;
  return state;
}

RigidObject slab(double massDamping) {
  const MassProperties box =
      massPropertiesOf(scenes::boxSurface(Vec3(-0.05, -0.03, -0.01), Vec3(0.05, 0.03, 0.01)), 2000).value();
  return RigidObject({true, true, 0, 7, 0, 6, 0}, box, massDamping, true);
}

struct RigidSystem {
  explicit RigidSystem(double dt, double massDamping) : body(slab(massDamping)) {
    const auto symbolic = std::make_shared<BlockSymbolic>(2, std::span<const std::array<int, 2>>{});
    BlockMatrix matrix(symbolic);
    matrix.setZero();
    b.setZero(6);
    StepSettings settings;
    settings.dt = dt;
    settings.gravity_W = gravity;
    VecX none;
    body.assemble(settings, state, body.blockEntries(*symbolic, 0), none, matrix, b);
    A = matrix.toDense();
    M = massByDifferences(body, state);
  }
  RigidObject body;
  State state = tumbling();
  Vec3 gravity{0.3, -9.81, 1};
  MatX A, M;
  VecX b;
};

TEST(RigidDerivatives, matrixIsMassAndDragOfTheKineticEnergy) {
  const double dt = 7e-3, alpha = 0.8;
  const RigidSystem system(dt, alpha);
  const MatX expected = (1 + dt * alpha) * system.M;
  EXPECT_LT((system.A - expected).norm(), 1e-14 * expected.norm());
}

TEST(RigidDerivatives, rightHandSideIsTheForceAndTheTurnKeepsTheMomentum) {
  // No torque acts, so b holds the momenta and the weight alone; the gyroscopic torque is what turning the body with
  // its momentum kept does to ω, against differences of I(t)⁻¹ L.
  const double dt = 5e-3;
  const RigidSystem system(dt, 0);
  VecX force = VecX::Zero(6);
  force.head<3>() = system.body.mass() * system.gravity;
  const VecX expected = dt * force + system.M * system.state.v;
  EXPECT_LT((system.b - expected).norm(), 1e-14 * expected.norm());

  const double h = 1e-5;
  State turned = system.state;
  system.body.advance(h, turned);
  const Vec3 omega = system.state.v.tail<3>();
  const Mat3 inertia = system.M.bottomRightCorner<3, 3>();
  const Vec3 gyroscopic = -inertia.inverse() * omega.cross(inertia * omega);
  // First order in h: a hundred-thousandth of a second of some radians a second.
  EXPECT_LT(((Vec3(turned.v.tail<3>()) - omega) / h - gyroscopic).norm(), 1e-3 * gyroscopic.norm());
  const Vec6 before = system.body.momentum(system.state);
  EXPECT_LT((system.body.momentum(turned) - before).norm(), 1e-12 * before.norm());
}

}  // namespace
}  // namespace glenoid
