// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/live/Pacer.h"

#include <algorithm>
#include <thread>

namespace glenoid {

Pacer::Pacer(double dt) : m_dt(dt) {}

void Pacer::waitForStep() {
  const auto step = std::chrono::duration_cast<Clock::duration>(m_dt);
  if (!m_started) {
    m_started = true;
    m_start = m_due = Clock::now();
  }
  std::this_thread::sleep_until(m_due);
  const auto late = Clock::now() - m_due;
  m_report.latenessMaxMs = std::max(m_report.latenessMaxMs, std::chrono::duration<double, std::milli>(late).count());
  if (late > step) ++m_report.lateSteps;
  if (late > kCatchUpSteps * step) {
    const auto given = late - kCatchUpSteps * step;
    m_due += given;
    m_report.slowedSeconds += std::chrono::duration<double>(given).count();
  }
  m_due += step;
}

PaceReport Pacer::report() const {
  PaceReport report = m_report;
  if (m_started) report.wallSeconds = std::chrono::duration<double>(Clock::now() - m_start).count();
  return report;
}

}  // namespace glenoid
