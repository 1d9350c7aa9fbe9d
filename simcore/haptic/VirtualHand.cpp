// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/haptic/VirtualHand.h"

#include <cmath>

namespace glenoid {

VirtualHand::VirtualHand(const VirtualHandSettings& settings, const Vec3& start)
    : m_settings(settings),
      m_x(start),
      m_commands(static_cast<std::size_t>(std::ceil(kDelayMost / settings.period)) + 2, Vec3::Zero()),
      m_delaySubsteps(std::lround(settings.delay / settings.period * kSubsteps)),
      m_handle(settings.deviceDamping, settings.period / kSubsteps),
      m_alone(0, settings.period / kSubsteps) {}

void VirtualHand::tick(const Vec3& commanded, const Vec3& target, const Vec3& targetVelocity, bool loaded) {
  const auto room = static_cast<long>(m_commands.size());
  m_commands[static_cast<std::size_t>(m_tick % room)] = commanded;
  const double h = m_settings.period / kSubsteps, m = m_settings.mass, k = m_settings.stiffness, c = m_settings.damping;
  const double firm = 2 * m / h + k * h / 2 + c + m_settings.deviceDamping;
  for (int s = 0; s < kSubsteps; ++s) {
    const long since = m_tick * kSubsteps + s - m_delaySubsteps;
    const Vec3 force = since < 0 ? Vec3(Vec3::Zero()) : m_commands[static_cast<std::size_t>(since / kSubsteps % room)];
    const Vec3 wanted = target + (s + 0.5) * h * targetVelocity;
    const Vec3 middle = (2 * m / h * m_v + force + m_settings.push + k * (wanted - m_x) + c * targetVelocity) / firm;
    const Vec3 moved = h * middle;
    const bool open = !loaded && force.norm() < PortEnergy::kNoForce;
    m_handle.add(force, moved, h, open);
    m_alone.add(force, moved, h, open);
    m_v = 2 * middle - m_v;
    m_x += moved;
  }
  ++m_tick;
}

}  // namespace glenoid
