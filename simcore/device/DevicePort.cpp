// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/device/DevicePort.h"

#include <algorithm>

#include "simcore/base/Turns.h"

namespace glenoid {

void DevicePort::say(const ToolInput& word) {
  m_words.back() = word;
  m_words.publish();
  m_present.store(true, std::memory_order_release);
}

DeviceForce DevicePort::force() {
  m_forces.take();
  return m_forces.front();
}

bool DevicePort::read(std::int64_t now, ToolInput& input) noexcept {
  if (!m_present.load(std::memory_order_acquire)) {
    m_anchor.lift();
    m_known = false;
    return false;
  }
  if (m_words.take()) {
    const ToolInput& word = m_words.front();
    m_from = m_to;
    m_to = word;
    m_to.pose = m_anchor.toWorld(word.pose);
    if (!m_known) m_from = m_to;
    m_apart = m_known ? std::clamp(1e-9 * static_cast<double>(m_to.stamp - m_from.stamp), 0.0, kApartMost) : 0;
    m_arrived = now;
    m_known = true;
  }
  if (!m_known) return false;
  input = m_to;
  if (!(m_hold > 0)) return true;
  if (1e-9 * static_cast<double>(now - m_to.stamp) <= m_hold) input.stamp = now;
  const double passed = 1e-9 * static_cast<double>(now - m_arrived);
  if (passed >= m_apart) return true;
  const double share = passed / m_apart;
  input.pose.p_WB = m_from.pose.p_WB + share * (m_to.pose.p_WB - m_from.pose.p_WB);
  input.pose.q_WB = turnTowards(m_from.pose.q_WB, m_to.pose.q_WB, share);
  return true;
}

void DevicePort::write(const Vec3& force, const Vec3& torque) noexcept {
  m_forces.back() = {m_anchor.toDevice(force), m_anchor.toDevice(torque)};
  m_forces.publish();
}

}  // namespace glenoid
