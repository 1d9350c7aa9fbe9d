// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/base/Math.h"

namespace glenoid {

/// Frame D of every hand device, whatever its maker calls it: X to the right of whoever holds it, Y up, Z toward him. Metres.

/// Brings a device's poses into the scene. The device's first word is where the tool's home is: a hand begins wherever it lies, and moves the
/// tool by as much as it moves, as seen from a camera. One that was gone begins again where the tool stayed.
class DeviceAnchor {
 public:
  static constexpr double kWildJump = 0.02;  ///< m from one word to the next: no place to go on from, as HapticLoop has it

  /// `q_WD`: the device's axes in W, the right, up and backward axes of whoever looks on; `home`: of the tool.
  DeviceAnchor(const Quat& q_WD, const Pose& home) : m_turn(q_WD.normalized()), m_base(home), m_last(home) {}

  /// Forgets where the device was: the next pose is where the tool is now.
  void lift() { m_held = false; }
  /// Of a pose of the device, D. What is not finite comes out as it went in, and anchors nothing.
  Pose toWorld(const Pose& pose);
  Vec3 toDevice(const Vec3& vector_W) const { return m_turn.conjugate() * vector_W; }

 private:
  Quat m_turn;
  Pose m_base, m_last, m_origin;
  Pose m_word;           ///< the last, believed or not
  bool m_held = false;
};

/// q_WD of somebody who looks from `eye` to `target` with `up` upwards; identity where that is no direction.
Quat deviceAxes(const Vec3& eye, const Vec3& target, const Vec3& up);

}  // namespace glenoid
