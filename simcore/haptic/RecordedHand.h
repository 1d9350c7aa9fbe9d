// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <atomic>
#include <span>

#include "simcore/haptic/HapticDevice.h"
#include "simcore/scene/Recording.h"

namespace glenoid {

/// A hand that follows a track of a recording by the clock, at whatever rate it is asked. Feels nothing: it goes where it
/// went. A run that takes its own hands from the same track, one step ahead of the clock, asks for `lead` = Δt, so that what
/// a step begins with is where this hand is then; a run that gives up time tells how much, and the hand goes at half its
/// pace until it is as far behind, as a person does who sees the picture slow down.
class RecordedHand : public HapticDevice {
 public:
  /// `track` outlives this; `start`: ns of the steady clock at time 0 of the track; `lead` in s. Without keys it stays at `home`.
  RecordedHand(const HandTrack& track, const Pose& home, std::int64_t start, double lead);

  /// Any thread: s that the run has given up since it began.
  void setBehind(double seconds) { m_behind.store(seconds, std::memory_order_relaxed); }
  /// Before the thread begins: where the track's time at each read goes while there is room.
  void setLog(std::span<double> times) { m_log = times; }
  /// Haptic thread, or once that is gone: time of the track at the last read.
  double trackTime() const { return m_time; }

  bool read(std::int64_t now, ToolInput& input) noexcept override;
  void write(const Vec3&, const Vec3&) noexcept override {}

 private:
  const HandTrack& m_track;
  Pose m_home;
  std::int64_t m_start, m_last;
  double m_lead, m_waited = 0, m_time = 0;
  std::atomic<double> m_behind{0};
  std::span<double> m_log;
  std::size_t m_logged = 0;
};

}  // namespace glenoid
