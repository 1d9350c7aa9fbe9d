// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/live/StepClock.h"

#include <cmath>

namespace glenoid {

void StepClock::restart(double now, double dt) {
  m_dt = dt;
  m_nextDue = now;
  m_forgiven = 0;
}

int StepClock::stepsDue(double now) {
  if (now < m_nextDue) return 0;
  const double due = std::floor((now - m_nextDue) / m_dt) + 1;
  const int steps = due > m_catchUpMax ? m_catchUpMax : static_cast<int>(due);
  m_nextDue += steps * m_dt;
  // Whole steps only, so that the phase stays.
  const double owed = std::floor((now - m_nextDue) / m_dt);
  if (due > m_catchUpMax && owed > 0) {
    m_nextDue += owed * m_dt;
    m_forgiven += owed * m_dt;
  }
  return steps;
}

}  // namespace glenoid
