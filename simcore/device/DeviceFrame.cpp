// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/device/DeviceFrame.h"

#include "simcore/tool/PoseSpring.h"

namespace glenoid {

Pose DeviceAnchor::toWorld(const Pose& pose) {
  if (!isHandPose(pose)) return pose;
  if (!m_held) {
    m_base = m_last;
    m_origin = pose;
    m_word = m_base;
    m_held = true;
  }
  Pose world;
  world.p_WB = m_base.p_WB + m_turn * (pose.p_WB - m_origin.p_WB);
  world.q_WB = (m_turn * (pose.q_WB * m_origin.q_WB.conjugate()) * m_turn.conjugate() * m_base.q_WB).normalized();
  // A single word far off, the last one perhaps before the device is gone, moves nothing when it comes back.
  if ((world.p_WB - m_word.p_WB).norm() <= kWildJump) m_last = world;
  return m_word = world;
}

Quat deviceAxes(const Vec3& eye, const Vec3& target, const Vec3& up) {
  const Vec3 back = eye - target, right = up.cross(back);
  if (!(back.norm() > 0) || !(right.norm() > 1e-9 * up.norm() * back.norm())) return Quat::Identity();
  Mat3 axes;
  axes.col(2) = back.normalized();
  axes.col(0) = right.normalized();
  axes.col(1) = axes.col(2).cross(axes.col(0));
  return Quat(axes);
}

}  // namespace glenoid
