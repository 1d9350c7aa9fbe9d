// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <chrono>

#include "simcore/live/RunReport.h"

namespace glenoid {

/// Lets each step begin when its time has come. A step that is late begins at once, so the run catches up; when
/// it is more than kCatchUpSteps behind, the schedule is moved instead: the simulation slows down, it never skips.
class Pacer {
 public:
  static constexpr int kCatchUpSteps = 4;
  explicit Pacer(double dt);  ///< dt in s

  /// Sleeps until the next step is due.
  void waitForStep();
  PaceReport report() const;

 private:
  using Clock = std::chrono::steady_clock;
  std::chrono::duration<double> m_dt;
  Clock::time_point m_start, m_due;
  bool m_started = false;
  PaceReport m_report;
};

}  // namespace glenoid
