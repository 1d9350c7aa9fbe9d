// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>

#include "simcore/base/Math.h"

namespace glenoid {

/// What a device says of a hand.
struct ToolInput {
  Pose pose;                 ///< where the hand wants the tool's tip, W
  double grip = 0;           ///< 0 open … 1 shut
  unsigned buttons = 0;      ///< a bit each
  std::int64_t stamp = 0;    ///< ns of the steady clock: when that was so
};

/// A hand at a haptic rate. Both calls come from the haptic thread once every tick: they must neither wait, allocate nor throw.
class HapticDevice {
 public:
  virtual ~HapticDevice() = default;
  /// The newest word, `now` in ns of the steady clock; false where the device is gone. What it says is checked by the caller.
  virtual bool read(std::int64_t now, ToolInput& input) noexcept = 0;
  /// Force, N, and torque about the grip, N·m, on the hand, W, until the next call.
  virtual void write(const Vec3& force, const Vec3& torque) noexcept = 0;
};

}  // namespace glenoid
