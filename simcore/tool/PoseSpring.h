// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/body/RigidObject.h"

namespace glenoid {

/// Six-directional spring and damper between a rigid body and a target pose: the virtual coupling of a tool to
/// the hand, or the hold of an arm. Taken implicitly at the frozen lever, so it is stable at any stiffness.
///   F = k (p_target − p) + c (ṗ_target − ṗ),  τ = kθ θ + cθ (ω_target − ω), θ = rotation vector of q_target q⁻¹
/// The linear part acts at `anchor_B`. Where the drive (spring, and damper for the target's own motion) would pass
/// forceMax or torqueMax it is cut to that, so a hand that jumps does not throw its tool. Stiffness and damping stay in
/// A, so the cut only adds damping.
/// Source: Colgate, Stanley and Brown, "Issues in the haptic display of tool use", IROS 1995 (virtual coupling).
struct PoseSpring {
  Vec3 anchor_B = Vec3::Zero();        ///< m, body frame (origin at the mass centre)
  double stiffness = 0;                ///< N/m
  double angularStiffness = 0;         ///< N·m/rad
  double damping = 0;                  ///< N·s/m
  double angularDamping = 0;           ///< N·m·s/rad
  double forceMax = 1e300;             ///< N
  double torqueMax = 1e300;            ///< N·m
  Vec3 axes = Vec3::Ones();            ///< 1 along the axes of W that it holds, 0 along those it leaves free
  Vec3 angularAxes = Vec3::Ones();     ///< the same for the components of θ
};

/// Where the anchor is wanted and how fast that moves.
struct PoseTarget {
  Vec3 anchor_W = Vec3::Zero();        ///< m
  Quat q_WB = Quat::Identity();        ///< wanted orientation of the body
  Vec3 velocity_W = Vec3::Zero();      ///< of the anchor, m/s
  Vec3 omega_W = Vec3::Zero();         ///< rad/s
};

/// Force (first three) at the anchor and torque (last three) of the springs alone, W, not cut.
Vec6 springWrench(const PoseSpring& spring, const RigidObject& body, const PoseTarget& target, const VecX& q);

/// Whether a pose can be where a hand is: finite, a rotation, and within a kilometre. Devices say other things too.
bool isHandPose(const Pose& hand);

/// Where a hand wants its tool, and how fast it moves there, from this and the last pose of the hand.
PoseTarget handTarget(const Pose& hand, const Pose& last, double dt);

/// The drive: the springs' wrench plus what the dampers give for the target's own motion, cut to the most they may be.
/// What resists the body's own velocity is not in it. The same layout as springWrench.
Vec6 driveWrench(const PoseSpring& spring, const RigidObject& body, const PoseTarget& target, const VecX& q);

/// Adds the spring to the body's two block rows of A and to its part of b; entries: (0,0), (1,1), (1,0).
void assemblePoseSpring(const PoseSpring& spring, const RigidObject& body, const PoseTarget& target, double dt,
                        const State& state, const std::array<BlockEntry, 3>& entries, BlockMatrix& A,
                        Eigen::Ref<VecX> b);

}  // namespace glenoid
