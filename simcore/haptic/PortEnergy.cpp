// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/haptic/PortEnergy.h"

#include <algorithm>
#include <cmath>

namespace glenoid {

PortEnergy::PortEnergy(double damping, double period)
    : m_damping(damping), m_length(std::lround(kWindow / period)), m_starts(static_cast<std::size_t>(m_length) + 2) {}

void PortEnergy::add(const Vec3& force, const Vec3& moved, double seconds, bool open) {
  const std::size_t room = m_starts.size();
  while (m_count > 0 && m_starts[m_first].tick < m_tick - m_length) {
    m_first = (m_first + 1) % room;
    --m_count;
  }
  if (open) {
    while (m_count > 0 && m_starts[(m_first + m_count - 1) % room].sum >= m_sum) --m_count;
    m_starts[(m_first + m_count) % room] = {m_tick, m_sum};
    ++m_count;
  }
  m_sum += force.dot(moved) - (seconds > 0 ? m_damping * moved.squaredNorm() / seconds : 0.0);
  ++m_tick;
  if (m_count > 0) m_worst = std::max(m_worst, m_sum - m_starts[m_first].sum);
}

}  // namespace glenoid
