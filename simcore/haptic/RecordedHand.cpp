// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/haptic/RecordedHand.h"

#include <algorithm>

namespace glenoid {

RecordedHand::RecordedHand(const HandTrack& track, const Pose& home, std::int64_t start, double lead)
    : m_track(track), m_home(home), m_start(start), m_last(start), m_lead(lead) {}

bool RecordedHand::read(std::int64_t now, ToolInput& input) noexcept {
  const double passed = 1e-9 * static_cast<double>(std::max<std::int64_t>(0, now - m_last));
  m_last = std::max(m_last, now);
  m_waited = std::min(m_behind.load(std::memory_order_relaxed), m_waited + 0.5 * passed);
  m_time = 1e-9 * static_cast<double>(m_last - m_start) + m_lead - m_waited;
  input.pose = m_track.keys.empty() ? m_home : handAt(m_track, m_time);
  input.stamp = now;
  if (m_logged < m_log.size()) m_log[m_logged++] = m_time;
  return true;
}

}  // namespace glenoid
