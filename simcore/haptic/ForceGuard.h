// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/base/Math.h"

namespace glenoid {

/// What stands between a computed force and a hand: no more than so much, no faster than so much, and nothing at all when
/// either side falls silent.
struct GuardLimits {
  double forceMax = 3;       ///< N, of the length
  double slewMax = 3000;     ///< N/s, of the change
  double dataPatience = 0.002;  ///< s without a new word of the device before its data count as lost
  double dataRamp = 0.003;      ///< s from then on to no force: 5 ms after the last word it is zero
  double silenceRamp = 0.005;   ///< s to no force for a simulation that has been silent for too long
  double comeBack = 0.05;       ///< s from no force to the whole one, once both speak again
};

/// Longest that a simulation with this time step may be silent: its last word is held for max(20 ms, 3 Δt).
double silencePatience(double dt);

/// Why the shown force is not the computed one; several at once.
struct GuardWord {
  bool clamped = false, slewed = false, lost = false, silent = false;
};

/// Allocates nothing. One for each device.
class ForceGuard {
 public:
  explicit ForceGuard(const GuardLimits& limits) : m_limits(limits) {}

  /// The force to show in the tick that begins, T seconds after the last one. `dataAge`: s since the device's last good word;
  /// infinite for one that is gone or wild. `simulationAge`: s since what the force was computed from was true;
  /// `simulationDt`: its step, s. What is not finite counts as lost.
  Vec3 show(const Vec3& wanted, double dataAge, double simulationAge, double simulationDt, double T);

  /// Another force was shown than show() answered: what comes next goes on from that.
  void showed(const Vec3& force) { m_shown = force; }

  const GuardWord& word() const { return m_word; }
  const Vec3& shown() const { return m_shown; }

 private:
  GuardLimits m_limits;
  GuardWord m_word;
  Vec3 m_shown = Vec3::Zero();
  Vec3 m_rampFrom = Vec3::Zero();
  double m_rampLeft = -1, m_rampLength = 1;  // left below 0: no ramp under way
  double m_back = 1;                         // share of the force that has come back
};

}  // namespace glenoid
