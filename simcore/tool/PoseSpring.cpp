// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/tool/PoseSpring.h"

#include "simcore/base/Turns.h"

namespace glenoid {

Vec6 springWrench(const PoseSpring& spring, const RigidObject& body, const PoseTarget& target, const VecX& q) {
  const Pose pose = body.pose(q);
  const Vec3 force = spring.stiffness * (target.anchor_W - pose * spring.anchor_B);
  const Vec3 theta = rotationVector(target.q_WB * pose.q_WB.conjugate());
  Vec6 wrench;
  wrench << spring.axes.cwiseProduct(force), spring.angularAxes.cwiseProduct(spring.angularStiffness * theta);
  return wrench;
}

bool isHandPose(const Pose& hand) {
  constexpr double kFarthest = 1e3;  // m from the origin, and no joint is that large
  if (!hand.p_WB.allFinite() || !hand.q_WB.coeffs().allFinite()) return false;
  const double length = hand.q_WB.coeffs().stableNorm();
  return hand.p_WB.cwiseAbs().maxCoeff() < kFarthest && length > 0.5 && length < 2;
}

PoseTarget handTarget(const Pose& hand, const Pose& last, double dt) {
  PoseTarget target;
  target.anchor_W = hand.p_WB;
  target.q_WB = hand.q_WB;
  target.velocity_W = (hand.p_WB - last.p_WB) / dt;
  Quat turn = hand.q_WB * last.q_WB.conjugate();
  if (turn.w() < 0) turn.coeffs() *= -1;
  target.omega_W = 2 * turn.vec() / dt;  // hands turn by little in a step
  return target;
}

Vec6 driveWrench(const PoseSpring& spring, const RigidObject& body, const PoseTarget& target, const VecX& q) {
  Vec6 wrench = springWrench(spring, body, target, q);
  wrench.head<3>() += spring.axes.cwiseProduct(spring.damping * target.velocity_W);
  wrench.tail<3>() += spring.angularAxes.cwiseProduct(spring.angularDamping * target.omega_W);
  const double pull = wrench.head<3>().norm(), turn = wrench.tail<3>().norm();
  if (pull > spring.forceMax) wrench.head<3>() *= spring.forceMax / pull;
  if (turn > spring.torqueMax) wrench.tail<3>() *= spring.torqueMax / turn;
  return wrench;
}

void assemblePoseSpring(const PoseSpring& spring, const RigidObject& body, const PoseTarget& target, double dt,
                        const State& state, const std::array<BlockEntry, 3>& entries, BlockMatrix& A,
                        Eigen::Ref<VecX> b) {
  const Vec3 lever = body.pose(state.q).q_WB * spring.anchor_B;
  const Mat3 cross = skew(lever);
  const double k = dt * dt * spring.stiffness + dt * spring.damping;
  const double kAngular = dt * dt * spring.angularStiffness + dt * spring.angularDamping;
  // ṗ = v − [lever] ω, so Jᵀ K J with K = k diag(axes) has the blocks K, [lever] K (1,0) and −[lever] K [lever].
  const Mat3 turned = k * cross * spring.axes.asDiagonal();
  A.add(entries[0], (k * spring.axes).asDiagonal().toDenseMatrix());
  A.add(entries[1], (kAngular * spring.angularAxes).asDiagonal().toDenseMatrix() - turned * cross);
  A.add(entries[2], turned);
  const Vec6 wrench = driveWrench(spring, body, target, state.q);
  const Vec3 force = wrench.head<3>();
  b.segment<3>(0) += dt * force;
  b.segment<3>(3) += dt * (lever.cross(force) + wrench.tail<3>());
}

}  // namespace glenoid
