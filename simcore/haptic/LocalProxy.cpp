// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/haptic/LocalProxy.h"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

#include "simcore/base/Turns.h"
#include "simcore/tool/PoseSpring.h"

namespace glenoid {

namespace {

constexpr int kMost = LocalProblem::kRows;
/// A hand that turns nothing is given this much, so that the problem has one answer: N·m/rad.
constexpr double kLeastAngular = 1e-6;
/// How long the far side is let go on by itself, in steps of the simulation.
constexpr double kGoesOn = 2;

Pose moved(const Pose& pose, const Vec6& d) {
  Pose next;
  next.p_WB = pose.p_WB + d.head<3>();
  next.q_WB = (turnBy(d.tail<3>()) * pose.q_WB).normalized();
  return next;
}

}  // namespace

LocalProxy::LocalProxy() : m_W(kMost, kMost), m_d(kMost), m_lambda(kMost) {
  // So that its scratch is there: a problem of the largest size.
  m_W.setIdentity();
  m_d.setConstant(-1);
  m_lambda.setZero();
  solveLcp(m_W, m_d, m_lambda, {}, m_work);
}

void LocalProxy::place(const LocalProblem& problem, const Pose& hand) {
  Pose tool;
  tool.q_WB = hand.q_WB;
  tool.p_WB = hand.p_WB - hand.q_WB * problem.grip_B;
  m_pose[0] = tool;
  for (int b = 1; b < problem.bodyCount; ++b) {  // as it lay beside the tool
    const Pose &first = problem.pose[0], &other = problem.pose[static_cast<std::size_t>(b)];
    const Quat turn = tool.q_WB * first.q_WB.conjugate();
    m_pose[static_cast<std::size_t>(b)].q_WB = (turn * other.q_WB).normalized();
    m_pose[static_cast<std::size_t>(b)].p_WB = tool.p_WB + turn * (other.p_WB - first.p_WB);
  }
  m_lastHand = hand;
  m_placed = true;
}

// The pull of all springs after a displacement d of the tick that began at m_pose.
LocalProxy::Unknowns LocalProxy::pull(const LocalProblem& problem, const Pose& hand, const ProxyGains& gains, double T, const Unknowns& d,
                                      ProxyForce& felt) const {
  Unknowns F = Unknowns::Zero();
  const Pose tool = moved(m_pose[0], d.head<6>());
  const Vec3 lever = tool.q_WB * problem.grip_B, lever0 = m_pose[0].q_WB * problem.grip_B;
  const Vec3 gripMoved = tool.p_WB + lever - m_pose[0].p_WB - lever0;
  Vec3 force = gains.stiffness * (hand.p_WB - tool.p_WB - lever) + gains.damping / T * (hand.p_WB - m_lastHand.p_WB - gripMoved);
  const Vec3 handTurn = rotationVector(hand.q_WB * m_lastHand.q_WB.conjugate());
  Vec3 torque = gains.angularStiffness * rotationVector(hand.q_WB * tool.q_WB.conjugate()) + gains.angularDamping / T * (handTurn - d.segment<3>(3));
  if (const double size = force.norm(); size > problem.forceMax) force *= problem.forceMax / size, felt.cut = true;
  if (const double size = torque.norm(); size > problem.torqueMax) torque *= problem.torqueMax / size, felt.cut = true;
  felt.force = -force;
  felt.torque = -torque;
  F.head<3>() = force;
  F.segment<3>(3) = lever.cross(force) + torque;
  for (int l = 0; l < problem.linkCount; ++l) {
    const LocalProblem::Link& link = problem.links[static_cast<std::size_t>(l)];
    const Pose other = moved(m_pose[1], d.segment<6>(6));
    const Vec3 ra = tool.q_WB * link.a_B, rb = other.q_WB * link.b_B;
    const Vec3 on = -link.stiffness * (tool.p_WB + ra - other.p_WB - rb);
    F.head<3>() += on;
    F.segment<3>(3) += ra.cross(on);
    F.segment<3>(6) -= on;
    F.segment<3>(9) -= rb.cross(on);
  }
  return F;
}

ProxyForce LocalProxy::solve(const LocalProblem& problem, const Pose& hand, const ProxyGains& asked, double T, double since) {
  ProxyForce felt;
  if (!problem.valid || problem.bodyCount < 1 || !isHandPose(hand) || !(asked.stiffness > 0)) {
    forget();
    return felt;
  }
  ProxyGains gains = asked;
  if (!m_placed) {
    place(problem, hand);
    gains.damping = gains.angularDamping = 0;  // how it came to be there is no motion
  }
  const int n = problem.rowCount, size = 6 * problem.bodyCount;

  // A: springs at their levers of now, and for a body that nothing turns a little beside.
  m_A.setIdentity();
  m_A.topLeftCorner(size, size).setZero();
  const double k = gains.stiffness + gains.damping / T;
  const double kAngular = std::max(kLeastAngular, gains.angularStiffness) + gains.angularDamping / T;
  const Mat3 grip = skew(m_pose[0].q_WB * problem.grip_B);
  m_A.block<3, 3>(0, 0).diagonal().array() += k;
  m_A.block<3, 3>(3, 0) += k * grip;
  m_A.block<3, 3>(0, 3) -= k * grip;
  m_A.block<3, 3>(3, 3) -= k * grip * grip;
  m_A.block<3, 3>(3, 3).diagonal().array() += kAngular;
  for (int l = 0; l < problem.linkCount; ++l) {
    const LocalProblem::Link& link = problem.links[static_cast<std::size_t>(l)];
    Eigen::Matrix<double, 3, LocalProblem::kUnknowns> J;
    J << Mat3::Identity(), -skew(m_pose[0].q_WB * link.a_B), -Mat3::Identity(), skew(m_pose[1].q_WB * link.b_B);
    m_A.noalias() += link.stiffness * J.transpose() * J;
  }
  if (problem.bodyCount > 1) m_A.diagonal().tail<6>().array() += kLeastAngular;
  const Eigen::LLT<Square> factor(m_A);
  if (factor.info() != Eigen::Success) {
    forget();
    return felt;
  }

  Unknowns d = factor.solve(pull(problem, hand, gains, T, Unknowns::Zero(), felt));
  if (n > 0) {
    Unknowns off = Unknowns::Zero();
    for (int b = 0; b < problem.bodyCount; ++b) {
      const Pose &from = problem.pose[static_cast<std::size_t>(b)], &at = m_pose[static_cast<std::size_t>(b)];
      off.segment<3>(6 * b) = at.p_WB - from.p_WB;
      off.segment<3>(6 * b + 3) = rotationVector(at.q_WB * from.q_WB.conjugate());
    }
    const double onwards = std::clamp(since, 0.0, kGoesOn * problem.dt);
    const auto J = problem.J.topRows(n);
    for (int i = 0; i < n; ++i) m_AinvJt.col(i) = factor.solve(J.row(i).transpose());
    for (int j = 0; j < n; ++j) {
      double there = 0;
      for (int i = 0; i < n; ++i) {
        m_W(i, j) = J.row(i).dot(m_AinvJt.col(j)) + problem.C(i, j);
        there += problem.C(j, i) * problem.force[static_cast<std::size_t>(i)];
      }
      const auto at = static_cast<std::size_t>(j);
      m_d[j] = problem.slack[at] + J.row(j).dot(off + d) + problem.approach[at] * onwards - there;
      m_lambda[j] = problem.force[at];
    }
    const LcpReport solved = solveLcp(m_W.topLeftCorner(n, n), m_d.head(n), m_lambda.head(n), {}, m_work);
    felt.exact = solved.exact;
    m_f.setZero();
    for (int i = 0; i < n; ++i) {
      m_f[i] = m_lambda[i];
      d += m_lambda[i] * m_AinvJt.col(i);
    }
  }
  const bool cut = felt.cut;
  felt.cut = false;
  pull(problem, hand, gains, T, d, felt);
  felt.cut = felt.cut || cut;
  if (!d.allFinite() || !felt.force.allFinite() || !felt.torque.allFinite()) {
    forget();
    return {};
  }
  for (int b = 0; b < problem.bodyCount; ++b) m_pose[static_cast<std::size_t>(b)] = moved(m_pose[static_cast<std::size_t>(b)], d.segment<6>(6 * b));
  m_lastHand = hand;
  return felt;
}

}  // namespace glenoid
