// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <gtest/gtest.h>

#include <chrono>
#include <functional>
#include <thread>

#include "simcore/device/DeviceLink.h"
#include "simcore/haptic/HapticLoop.h"
#include "simcore/haptic/HapticThread.h"
#include "tests/simcore/haptic/Walls.h"

namespace glenoid::test {

/// A haptic loop by hand: about a tick a millisecond, in the thread of the test.
class Feeling {
 public:
  explicit Feeling(HapticDevice& device) : m_device(device), m_loop(settings()) {}

  void tick() {
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
    const std::int64_t now = steadyNow();
    LocalProblem problem = test::wall();
    problem.stamp = now;
    present = m_device.read(now, input);
    answer = m_loop.tick(now, T, present, input, problem);
    m_device.write(answer.force, answer.torque);
  }
  /// Ticks until it is so, for at most ten seconds: a machine that many share may be slow.
  [[nodiscard]] bool until(const std::function<bool()>& so) {
    for (const auto begin = std::chrono::steady_clock::now(); std::chrono::steady_clock::now() - begin < std::chrono::seconds(10);) {
      tick();
      if (so()) return true;
    }
    return false;
  }
  void ticks(int count) {
    for (int i = 0; i < count; ++i) tick();
  }

  bool present = false;
  ToolInput input;
  HapticLoop::Answer answer;
  const HapticCounts& counts() const { return m_loop.counts(); }

 private:
  static HapticSettings settings() {
    HapticSettings all;
    all.device = unknownDevice();
    all.device.damping = 2;
    return all;
  }
  HapticDevice& m_device;
  HapticLoop m_loop;
};

/// The tool's home is 2 mm deep in the wall, so that whoever holds it is pushed at once.
inline DeviceAnchor pressedHome(const Quat& axes = Quat::Identity()) { return {axes, {Vec3(0, -0.002, 0), Quat::Identity()}}; }

}  // namespace glenoid::test
