// SPDX-License-Identifier: GPL-3.0-or-later
// What a pose spring adds to A and b against differences of its wrench, at the frozen lever.
#include <gtest/gtest.h>

#include <Eigen/Eigenvalues>

#include "simcore/tool/PoseSpring.h"

namespace glenoid {
namespace {

constexpr double kDt = 7e-3;

struct Held {
  Held()
      : body(ObjectLayout{true, true, 0, 7, 0, 6, 0}, {0.05, Vec3::Zero(), 1e-4 * Mat3::Identity()}, 0.0,
             false) {
    state.q.resize(7);
    setPoseAt(state.q, 0,
              {Vec3(0.1, 0.03, -0.02), Quat(Eigen::AngleAxisd(1.3, Vec3(1, -1, 2).normalized()))});
    state.v.setZero(6);
    spring.anchor_B = Vec3(0.01, -0.02, -0.08);
    spring.stiffness = 800;
    spring.angularStiffness = 2;
    spring.damping = 12;
    spring.angularDamping = 0.1;
  }

  /// Target that is `offset` away from the anchor and turned against the body by `turn` about a fixed axis.
  PoseTarget targetAt(const Vec3& offset, double turn) const {
    PoseTarget target;
    const Pose pose = body.pose(state.q);
    target.anchor_W = pose * spring.anchor_B + offset;
    target.q_WB = Quat(Eigen::AngleAxisd(turn, Vec3(2, 1, -1).normalized())) * pose.q_WB;
    target.velocity_W = Vec3(0.2, -0.1, 0.3);
    target.omega_W = Vec3(1, 2, -1);
    return target;
  }

  void assemble(const PoseTarget& target, MatX& A, VecX& b) const {
    const std::array<int, 2> pair{1, 0};
    const auto symbolic = std::make_shared<BlockSymbolic>(2, std::span(&pair, 1));
    BlockMatrix matrix(symbolic);
    matrix.setZero();
    b.setZero(6);
    assemblePoseSpring(spring, body, target, kDt, state,
                       {symbolic->entry(0, 0), symbolic->entry(1, 1), symbolic->entry(1, 0)}, matrix, b);
    A = matrix.toDense();
  }

  /// The body moved by h along ±velocity j.
  VecX moved(Eigen::Index j, double speed, double h) const {
    State at = state;
    at.v[j] = speed;
    body.advance(h, at);
    return at.q;
  }

  /// J of the anchor and of the orientation: three rows and three rows.
  MatX jacobian() const {
    const double h = 1e-5;
    MatX J = MatX::Zero(6, 6);
    for (int j = 0; j < 6; ++j)
      J.col(j).head<3>() =
          (body.pose(moved(j, 1, h)) * spring.anchor_B - body.pose(moved(j, -1, h)) * spring.anchor_B) /
          (2 * h);
    J.block<3, 3>(3, 3).setIdentity();  // ω itself
    return J;
  }

  /// −∂/∂q G of the wrench at the anchor, its lever not yet applied.
  MatX wrenchSlope(const PoseTarget& target) const {
    const double h = 1e-5;
    MatX slope(6, 6);
    for (int j = 0; j < 6; ++j)
      slope.col(j) = (springWrench(spring, body, target, moved(j, -1, h)) -
                      springWrench(spring, body, target, moved(j, 1, h))) /
                     (2 * h);
    return slope;
  }

  RigidObject body;
  PoseSpring spring;
  State state;
};

Vec6 damping(const PoseSpring& s) {
  Vec6 d;
  d << s.damping * Vec3::Ones(), s.angularDamping * Vec3::Ones();
  return d;
}

TEST(PoseSpringDerivatives, matrixIsThatOfTheWrenchNearTheTarget) {
  const Held held;
  const PoseTarget target = held.targetAt(Vec3(0.01, 0.02, -0.005), 0);
  MatX A;
  VecX b;
  held.assemble(target, A, b);
  const MatX J = held.jacobian();
  const MatX expected =
      J.transpose() * (kDt * kDt * held.wrenchSlope(target) + kDt * (damping(held.spring).asDiagonal() * J));
  // Differences over 2e-5 of a rotation vector near zero keep ten digits.
  EXPECT_LT((A - expected).norm(), 1e-9 * expected.norm());
}

TEST(PoseSpringDerivatives, rightHandSideIsTheWrenchWithTheTargetsMotion) {
  const Held held;
  const PoseTarget target = held.targetAt(Vec3(0.01, 0.02, -0.005), 0.9);
  MatX A;
  VecX b;
  held.assemble(target, A, b);
  Vec6 wrench = springWrench(held.spring, held.body, target, held.state.q), motion;
  motion << target.velocity_W, target.omega_W;
  wrench += damping(held.spring).asDiagonal() * motion;
  const VecX expected = kDt * held.jacobian().transpose() * wrench;
  EXPECT_LT((b - expected).norm(), 1e-10 * expected.norm());
}

TEST(PoseSpringDerivatives, farFromTheTargetTheMatrixIsOnTheSafeSide) {
  // The rotation vector θ of the error changes by less than ω across its axis: −∂θ/∂ω has the eigenvalues 1
  // and (θ/2)/tan(θ/2) ± iθ/2. A takes 1 for all: stiffer than the spring, so never unstable. Along θ it is
  // exact.
  const Held held;
  for (const double turn : {0.3, 1.0, 2.5}) {
    const PoseTarget target = held.targetAt(Vec3::Zero(), turn);
    const Mat3 slope = held.wrenchSlope(target).block<3, 3>(3, 3) / held.spring.angularStiffness;
    const Mat3 symmetric = 0.5 * (slope + slope.transpose());
    const Vec3 axis = Vec3(2, 1, -1).normalized();
    EXPECT_NEAR(axis.dot(symmetric * axis), 1, 1e-8);
    EXPECT_NEAR(symmetric.trace(), 1 + turn / std::tan(turn / 2), 1e-7);
    EXPECT_NEAR((slope - symmetric).norm(), turn / std::sqrt(2), 1e-7);
  }
}

TEST(PoseSpringDerivatives, beyondTheLargestForceTheMatrixOnlyAddsDamping) {
  Held held;
  held.spring.forceMax = 3;
  const PoseTarget target = held.targetAt(Vec3(0.2, -0.1, 0.1), 0);  // 196 N without the cut
  MatX A, uncut;
  VecX b;
  held.assemble(target, A, b);
  held.spring.forceMax = 1e300;
  held.assemble(target, uncut, b);
  EXPECT_EQ(A, uncut);
  held.spring.forceMax = 3;
  // The cut force turns but does not grow: its slope lies between nothing and the spring's own.
  const Mat3 slope = held.wrenchSlope(target).block<3, 3>(0, 0);
  const Vec3 values = Eigen::SelfAdjointEigenSolver<Mat3>(0.5 * (slope + slope.transpose())).eigenvalues();
  EXPECT_GT(values[0], -1e-6 * held.spring.stiffness);
  EXPECT_LT(values[2], held.spring.stiffness);
}

}  // namespace
}  // namespace glenoid
