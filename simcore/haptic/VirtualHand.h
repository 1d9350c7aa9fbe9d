// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/haptic/PortEnergy.h"

namespace glenoid {

/// A hand that holds a device, in a time of its own, to judge a haptic loop without either: a mass on a spring and damper to
/// where the hand wants to be, with the damping of the mechanism, pushed by forces that are held for a tick and come `delay`
/// after they were computed. Each axis alike, no rotation. Repeats to the last bit.
struct VirtualHandSettings {
  double mass = 0.15;            ///< of device and fingers, kg
  double stiffness = 300;        ///< N/m: how firmly the hand wants to be there
  double damping = 3;            ///< N·s/m: of the hand
  double deviceDamping = 1;      ///< N·s/m: of the mechanism
  double period = 0.001;         ///< s of a tick
  double delay = 0;              ///< s, to the nearest 1/kSubsteps of a tick
  Vec3 push = Vec3::Zero();      ///< N, constant, for tests
};

class VirtualHand {
 public:
  static constexpr int kSubsteps = 20;
  static constexpr double kDelayMost = 0.05;  ///< s

  VirtualHand(const VirtualHandSettings& settings, const Vec3& start);

  /// One tick: `commanded` was computed from position() as it is now; the hand wants to be at `target`, which moves at
  /// `targetVelocity`. By the midpoint rule, which is exact in the energies that are counted. `loaded`: a spring is, though nothing
  /// may be commanded.
  void tick(const Vec3& commanded, const Vec3& target, const Vec3& targetVelocity, bool loaded = false);

  const Vec3& position() const { return m_x; }
  const Vec3& velocity() const { return m_v; }
  /// J that loop and mechanism together gave to the hand in the worst window, and the loop alone (PortEnergy).
  double energyMade() const { return m_handle.worst(); }
  double loopEnergyMade() const { return m_alone.worst(); }

 private:
  VirtualHandSettings m_settings;
  Vec3 m_x, m_v = Vec3::Zero();
  std::vector<Vec3> m_commands;   // a ring of the last ones
  long m_tick = 0, m_delaySubsteps;
  PortEnergy m_handle, m_alone;
};

}  // namespace glenoid
