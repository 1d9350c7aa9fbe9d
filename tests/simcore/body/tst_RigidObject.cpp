// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <Eigen/Cholesky>

#include "simcore/body/RigidObject.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {
namespace {

ObjectLayout freeLayout() { return {true, true, 0, 7, 0, 6, 0}; }

State stateOf(const Pose& pose, const Vec6& velocity) {
  State state;
  state.q.resize(7);
  setPoseAt(state.q, 0, pose);
  state.v = velocity;
  return state;
}

TEST(RigidObject, massOfABoxInClosedForm) {
  const Vec3 size(0.1, 0.2, 0.3), low(0.5, -1, 2);
  const MassProperties box = massPropertiesOf(scenes::boxSurface(low, low + size, 3), 1000).value();
  EXPECT_NEAR(box.mass, 6, 1e-12);
  EXPECT_LT((box.centre - (low + 0.5 * size)).norm(), 1e-13);
  const Vec3 expected = 6.0 / 12 * Vec3(0.04 + 0.09, 0.01 + 0.09, 0.01 + 0.04);
  EXPECT_LT((box.inertia - Mat3(expected.asDiagonal())).norm(), 1e-13);
}

TEST(RigidObject, surfaceInsideOutIsRefused) {
  TriMesh mesh = scenes::boxSurface(Vec3::Zero(), Vec3::Ones());
  for (auto& t : mesh.triangles) std::swap(t[0], t[1]);
  EXPECT_EQ(massPropertiesOf(mesh, 1000).error().fault, Fault::BadMesh);
}

TEST(RigidObject, pointRowsAreTheDerivativeOfPosition) {
  const MassProperties box = massPropertiesOf(scenes::boxSurface(-0.1 * Vec3::Ones(), 0.1 * Vec3::Ones()), 1000).value();
  const RigidObject body(freeLayout(), box, 0, true);
  const Pose pose{Vec3(1, 2, 3), Quat(Eigen::AngleAxisd(0.8, Vec3(1, -1, 2).normalized()))};
  Vec6 v;
  v << 0.3, -0.2, 0.5, 1.0, 2.0, -1.5;
  State state = stateOf(pose, v);
  MaterialPoint point;
  point.r_B = Vec3(0.05, -0.07, 0.02);
  const Vec3 direction(0.3, 0.5, -0.8);
  RowTerm terms[kMaxPointTerms];
  const int count = body.rowTerms(point, direction, state.q, 0, terms);
  double row = 0;
  for (int i = 0; i < count; ++i) row += terms[i].coefficient.dot(v.segment<3>(3 * terms[i].block));
  const Vec3 before = body.position(point, state.q);
  const double h = 1e-7;
  body.advance(h, state);
  EXPECT_NEAR(row, direction.dot(body.position(point, state.q) - before) / h, 1e-5);
  EXPECT_NEAR(row, direction.dot(body.velocity(point, stateOf(pose, v).q, v)), 1e-14);
}

TEST(RigidObject, freeFallIsSemiImplicitEuler) {
  const MassProperties box = massPropertiesOf(scenes::boxSurface(-0.1 * Vec3::Ones(), 0.1 * Vec3::Ones()), 1000).value();
  const RigidObject body(freeLayout(), box, 0, true);
  const auto symbolic = std::make_shared<BlockSymbolic>(2, std::span<const std::array<int, 2>>{});
  BlockMatrix A(symbolic);
  VecX b = VecX::Zero(6), rotations;
  Vec6 v;
  v << 1, 0, 0, 0, 0, 0;
  const State state = stateOf({}, v);
  StepSettings settings;
  settings.gravity_W = Vec3(0, -10, 0);
  settings.dt = 0.01;
  body.assemble(settings, state, body.blockEntries(*symbolic, 0), rotations, A, b);
  EXPECT_LT((A.block(0, 0) - 8 * Mat3::Identity()).norm(), 1e-12);
  EXPECT_LT((b.head<3>() / 8 - Vec3(1, -0.1, 0)).norm(), 1e-12);
}

TEST(RigidObject, aFixedOneHasNoRowsAndStays) {
  ObjectLayout layout = freeLayout();
  layout.free = false;
  layout.vSize = 0;
  const RigidObject body(layout, massPropertiesOf(scenes::boxSurface(Vec3::Zero(), Vec3::Ones()), 1).value(), 0, true);
  RowTerm terms[kMaxPointTerms];
  State state = stateOf({}, Vec6::Ones());
  const VecX before = state.q;
  EXPECT_EQ(body.rowTerms({}, Vec3::UnitX(), state.q, 0, terms), 0);
  body.advance(1, state);
  EXPECT_EQ(state.q, before);
  EXPECT_EQ(body.blockCount(), 0);
}

TEST(RigidObject, quaternionStaysUnitOverManySteps) {
  const RigidObject body(freeLayout(), massPropertiesOf(scenes::boxSurface(Vec3::Zero(), Vec3::Ones()), 1).value(), 0, true);
  Vec6 v;
  v << 0, 0, 0, 5, -3, 2;
  State state = stateOf({}, v);
  for (int i = 0; i < 100000; ++i) body.advance(0.005, state);
  EXPECT_NEAR(state.q.tail<4>().norm(), 1, 1e-14);
}

/// The body alone through steps of dt; answers its pose and velocity after `seconds`.
State spinFreely(const MassProperties& properties, const Vec6& velocity, double dt, double seconds) {
  const RigidObject body(freeLayout(), properties, 0, true);
  const auto symbolic = std::make_shared<BlockSymbolic>(2, std::span<const std::array<int, 2>>{});
  const auto entries = body.blockEntries(*symbolic, 0);
  BlockMatrix A(symbolic);
  State state = stateOf({}, velocity);
  VecX b(6), rotations;
  StepSettings settings;
  settings.dt = dt;
  for (long i = 0; i < std::lround(seconds / dt); ++i) {
    A.setZero();
    b.setZero();
    body.assemble(settings, state, entries, rotations, A, b);
    state.v = A.toDense().llt().solve(b);
    body.advance(dt, state);
  }
  return state;
}

MassProperties slab() { return massPropertiesOf(scenes::boxSurface(Vec3(-0.05, -0.03, -0.01), Vec3(0.05, 0.03, 0.01)), 2000).value(); }

Vec6 spin(const Vec3& omega) {
  Vec6 v;
  v << Vec3::Zero(), omega;
  return v;
}

TEST(RigidObject, keepsSpinningAboutAPrincipalAxis) {
  for (int axis = 0; axis < 3; ++axis) {
    const State end = spinFreely(slab(), spin(20 * Vec3::Unit(axis)), 5e-3, 1);
    EXPECT_LT((end.v - spin(20 * Vec3::Unit(axis))).norm(), 1e-10) << "the middle axis is unstable, but round-off grows by e^20·0.6 only";
    const Quat expected(Eigen::AngleAxisd(20.0, Vec3::Unit(axis)));
    EXPECT_LT(poseAt(end.q, 0).q_WB.angularDistance(expected), 1e-10);
  }
}

TEST(RigidObject, freeTumblingKeepsEnergyAndTheSizeOfTheAngularMomentumAtAnyStep) {
  // The midpoint rule keeps both exactly; what is left is round-off of the steps, which adds up like a random walk.
  for (const double dt : {1e-3, 5e-3, 2e-2})
    for (const double speed : {10.0, 100.0}) {
      const Vec6 v = spin(speed * Vec3(0.3, 1, 0.2).normalized());
      const RigidObject body(freeLayout(), slab(), 0, true);
      const State start = stateOf({}, v), end = spinFreely(slab(), v, dt, 10);
      const double energy = body.kineticEnergy(start), momentum = body.momentum(start).tail<3>().norm();
      if (speed * dt < 1.5) {
        EXPECT_NEAR(body.kineticEnergy(end), energy, 1e-11 * energy) << dt << " s at " << speed << " rad/s";
        EXPECT_NEAR(body.momentum(end).tail<3>().norm(), momentum, 1e-11 * momentum);
      }
      EXPECT_LT(body.kineticEnergy(end), (1 + 1e-11) * energy);
    }
}

TEST(RigidObject, aSymmetricTopPrecessesAsEulerSays) {
  // I₁ = I₂: in the body ω turns about the axis at (I₃ − I₁)/I₁ ω₃; in W the axis circles about the fixed angular
  // momentum at |L|/I₁. Turning the pose about the step's last ω leaves an error of first order.
  const MassProperties top = massPropertiesOf(scenes::boxSurface(Vec3(-0.04, -0.04, -0.01), Vec3(0.04, 0.04, 0.01)), 2000).value();
  const RigidObject body(freeLayout(), top, 0, true);
  const Vec3 omega(2, 0, 9);
  const double seconds = 1, I1 = top.inertia(0, 0), I3 = top.inertia(2, 2);
  const Vec3 L = body.momentum(stateOf({}, spin(omega))).tail<3>();
  const Vec3 axis = Eigen::AngleAxisd(L.norm() / I1 * seconds, L.normalized()) * Vec3::UnitZ();
  const double turn = (I3 - I1) / I1 * omega.z() * seconds;
  const Vec3 omega_B(2 * std::cos(turn), 2 * std::sin(turn), 9);
  double axisError[2], omegaError[2];
  for (int i = 0; i < 2; ++i) {
    const State end = spinFreely(top, spin(omega), i ? 1e-3 : 2e-3, seconds);
    const Quat q = poseAt(end.q, 0).q_WB;
    axisError[i] = (q * Vec3::UnitZ() - axis).norm();
    omegaError[i] = (q.conjugate() * Vec3(end.v.tail<3>()) - omega_B).norm() / 2;
  }
  EXPECT_NEAR(std::log2(omegaError[0] / omegaError[1]), 2, 0.1) << omegaError[0] << " at 2 ms, " << omegaError[1] << " at 1 ms";
  EXPECT_NEAR(std::log2(axisError[0] / axisError[1]), 1, 0.2) << axisError[0] << " at 2 ms, " << axisError[1] << " at 1 ms";
  EXPECT_LT(omegaError[1], 1e-4);
  EXPECT_LT(axisError[1], 0.02);
}

}  // namespace
}  // namespace glenoid
