// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <span>

#include "simcore/haptic/DeviceProfile.h"
#include "simcore/haptic/EnergyTank.h"
#include "simcore/haptic/ForceGuard.h"
#include "simcore/haptic/HapticDevice.h"
#include "simcore/haptic/LocalProxy.h"
#include "simcore/haptic/PortEnergy.h"

namespace glenoid {

/// How forces are made for one device.
struct HapticSettings {
  DeviceProfile device;
  double rate = 1000;       ///< Hz of the loop
  double addedDelay = 0;    ///< s on top of the device's own, known to whoever asks; gains shrink with it
};

/// Counts since the loop began, and the last tick.
struct HapticCounts {
  long ticks = 0;
  long clamped = 0, slewed = 0;  ///< ticks in which the force was cut, or its change
  long lost = 0, silent = 0;     ///< ticks in which the device or the simulation had no say
  long heard = 0, lostOnceHeard = 0;  ///< ticks in which the device was believed; lost ones since the first of these
  double lostFrom = 0;           ///< s of the loop's own count, of the first of those
  long heldBack = 0;             ///< ticks in which the force was cut so that it gives no more than was put in (EnergyTank)
  long inexact = 0;              ///< ticks whose contact problem was not solved to the last row
  long overflow = 0;             ///< ticks whose problem had more rows in reach than places
  int rows = 0, rowsMax = 0, overflowMax = 0;
  double forceMax = 0;           ///< N, most shown
  double energyMax = 0;          ///< J made at the handle, the mechanism's damping taken off (PortEnergy)
  double loopEnergyMax = 0;      ///< J, the same without the mechanism
  double problemAge = 0, problemAgeMax = 0;  ///< s since what the last force was computed from was true
  CouplingGains gains;
  Vec3 force = Vec3::Zero();     ///< N, shown last
  GuardWord word;
};

/// One tick, for whoever wants to compare afterwards.
struct HapticSample {
  std::int64_t time = 0;         ///< ns of the steady clock
  Vec3 hand = Vec3::Zero();      ///< m, W
  Vec3 wanted = Vec3::Zero(), shown = Vec3::Zero();  ///< N
};

/// What is done once every tick: device in, problem in, force out. Knows no thread and no clock but the times it is given, so
/// that a bench may run it in a time of its own; takes no lock, allocates nothing after construction.
class HapticLoop {
 public:
  explicit HapticLoop(const HapticSettings& settings);

  /// Room for samples; the loop writes while there is some. The owner keeps it until the loop is gone.
  void setLog(std::span<HapticSample> log) { m_log = log; }
  std::size_t logged() const { return m_logged; }

  struct Answer {
    Vec3 force = Vec3::Zero(), torque = Vec3::Zero();
  };
  /// `now` in ns; T: s since the last tick by the loop's own count, missed ones included. `present`: the device had a word at all.
  /// `problem` may be one that is not valid yet.
  Answer tick(std::int64_t now, double T, bool present, const ToolInput& input, const LocalProblem& problem);

  const HapticCounts& counts() const { return m_counts; }
  /// Nothing was loaded in the last tick, no spring and no tissue.
  bool open() const { return m_open; }
  const HapticSettings& settings() const { return m_settings; }
  const LocalProxy& proxy() const { return m_proxy; }
  /// Where the hand was when it was last believed; nothing before that.
  const std::optional<Pose>& hand() const { return m_believedHand; }

  /// A hand that goes farther than this in a tick is none: m.
  static constexpr double kWildJump = 0.02;
  /// Ticks in a row that a device which was gone or wild must be good before it is believed again.
  static constexpr int kTrustAfter = 10;

 private:
  HapticSettings m_settings;
  LocalProxy m_proxy;
  ForceGuard m_guard;
  PortEnergy m_handle, m_alone;
  EnergyTank m_tank;
  bool m_open = true;         ///< nothing was loaded in the last tick
  HapticCounts m_counts;
  Pose m_lastHand;
  std::optional<Pose> m_believedHand;
  double m_time = 0;          ///< s, of all ticks
  bool m_seen = false;        ///< m_lastHand is the last tick's
  int m_doubt = 0;            ///< good ticks still wanted
  double m_wishedStiffness = -1;
  std::span<HapticSample> m_log;
  std::size_t m_logged = 0;
};

}  // namespace glenoid
