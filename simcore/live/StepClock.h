// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace glenoid {

/// Ties fixed steps to a clock that belongs to the caller (Pacer sleeps on its own; this one only counts, so that
/// a thread can wait for commands meanwhile). A run that is late catches up by at most `catchUpMax` steps at a
/// time; what it owes beyond that is forgiven, so the simulation slows down against the clock and says so. A step
/// is never skipped and never longer. Times are seconds of any steady clock.
class StepClock {
 public:
  explicit StepClock(int catchUpMax = 4) : m_catchUpMax(catchUpMax) {}

  /// The next step is due at `now`; nothing is owed.
  void restart(double now, double dt);
  /// Steps to take now, 0…catchUpMax; they count as taken.
  int stepsDue(double now);
  /// When the next step is due, s.
  double nextDue() const { return m_nextDue; }
  /// Time forgiven since restart, s: how far the simulation has fallen behind the clock for good.
  double forgiven() const { return m_forgiven; }

 private:
  int m_catchUpMax;
  double m_dt = 0.005, m_nextDue = 0, m_forgiven = 0;
};

}  // namespace glenoid
