// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <atomic>

#include "simcore/base/TripleBuffer.h"
#include "simcore/device/DeviceFrame.h"
#include "simcore/haptic/HapticDevice.h"

namespace glenoid {

/// Force and torque for a hand, D.
struct DeviceForce {
  Vec3 force = Vec3::Zero();   ///< N
  Vec3 torque = Vec3::Zero();  ///< N·m
};

/// Between the thread that talks with a device and the haptic thread: words one way, forces the other, the newest of each, by buffers on
/// which nobody waits. Words are in the device's frame D, what the loop reads in W.
class DevicePort : public HapticDevice {
 public:
  /// `hold`: s for which a word is good without another one: 0 for a device that shows forces, whose silence must count; more for one
  /// that says nothing while it is at rest, or speaks less often than the loop asks. Such words are gone through evenly, as late as
  /// they are apart (at most 50 ms).
  DevicePort(const DeviceAnchor& anchor, double hold) : m_anchor(anchor), m_hold(hold) {}

  // The thread that talks.
  /// `word.stamp`: when it came, ns of the steady clock.
  void say(const ToolInput& word);
  /// False: the device is gone, and what it said last is no pose of a hand any more. It is there again with the next word.
  void leave() { m_present.store(false, std::memory_order_release); }
  /// The newest force; zero before the first.
  DeviceForce force();

  // The haptic thread.
  bool read(std::int64_t now, ToolInput& input) noexcept override;
  void write(const Vec3& force, const Vec3& torque) noexcept override;

 private:
  static constexpr double kApartMost = 0.05;  ///< s

  DeviceAnchor m_anchor;
  double m_hold;
  std::atomic<bool> m_present{false};
  TripleBuffer<ToolInput> m_words;
  TripleBuffer<DeviceForce> m_forces;
  ToolInput m_from, m_to;      // in W, for what is gone through evenly
  std::int64_t m_arrived = 0;  // ns: when the loop saw m_to
  double m_apart = 0;          // s
  bool m_known = false;
};

}  // namespace glenoid
