// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/contact/Lcp.h"
#include "simcore/contact/LocalProblem.h"

namespace glenoid {

/// Gains of the spring between hand and tool as the haptic loop shows it.
struct ProxyGains {
  double stiffness = 0, damping = 0;                ///< N/m, N·s/m
  double angularStiffness = 0, angularDamping = 0;  ///< N·m/rad, N·m·s/rad
};

/// What the hand feels at the grip, W.
struct ProxyForce {
  Vec3 force = Vec3::Zero();   ///< N
  Vec3 torque = Vec3::Zero();  ///< N·m about the grip
  bool cut = false;            ///< the spring's pull was cut to the most the scenario lets a hand pull
  bool exact = true;           ///< the complementarity problem was solved to the last row
};

/// The tool as the haptic loop knows it: without mass, pulled by the hand's spring, kept out of what a LocalProblem says is
/// near. Each tick it moves by the d that minimises what is in springs, hand, links and the far side together,
///   A d = F + J^T f,   0 ≤ f ⊥ s(d, f) ≥ 0,   A = K + B/T of the grip and K of the links,
/// one complementarity problem of J A⁻¹ J^T + C, solved exactly. A spring to a point that keeps out of things: in the open the hand
/// feels nothing; against what cannot give it feels K times how far it went in, at whatever rate that is asked.
/// Implicit in everything but the hand, so it gives out no energy by itself; between two problems the far side is a spring too.
/// Allocates nothing after construction.
/// Source: Ruspini, Kolarov and Khatib, "The haptic display of complex graphical environments", SIGGRAPH 1997 (proxy);
/// Colgate, Stanley and Brown, IROS 1995 (virtual coupling).
class LocalProxy {
 public:
  LocalProxy();

  /// The next solve starts with the tool as the hand has it.
  void forget() { m_placed = false; }

  /// One tick of T seconds, `since` seconds after what the problem says was true. A problem that is not valid, or a hand
  /// that is no pose, gives no force and forgets.
  ProxyForce solve(const LocalProblem& problem, const Pose& hand, const ProxyGains& asked, double T, double since);

  const Pose& pose(int body) const { return m_pose[static_cast<std::size_t>(body)]; }
  /// Forces of the last solve by row, N.
  const Eigen::Matrix<double, LocalProblem::kRows, 1>& rowForces() const { return m_f; }

 private:
  using Square = Eigen::Matrix<double, LocalProblem::kUnknowns, LocalProblem::kUnknowns>;
  using Unknowns = Eigen::Matrix<double, LocalProblem::kUnknowns, 1>;

  void place(const LocalProblem& problem, const Pose& hand);
  Unknowns pull(const LocalProblem& problem, const Pose& hand, const ProxyGains& gains, double T, const Unknowns& d, ProxyForce& felt) const;

  bool m_placed = false;
  std::array<Pose, LocalProblem::kBodies> m_pose;
  Pose m_lastHand;
  Square m_A;
  Eigen::Matrix<double, LocalProblem::kUnknowns, LocalProblem::kRows> m_AinvJt;
  MatX m_W;
  VecX m_d, m_lambda;
  Eigen::Matrix<double, LocalProblem::kRows, 1> m_f = Eigen::Matrix<double, LocalProblem::kRows, 1>::Zero();
  LcpWork m_work;
};

}  // namespace glenoid
