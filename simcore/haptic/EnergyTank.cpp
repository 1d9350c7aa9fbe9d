// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/haptic/EnergyTank.h"

#include <algorithm>

#include "simcore/haptic/PortEnergy.h"

namespace glenoid {

void EnergyTank::add(const Vec3& force, const Vec3& moved, double seconds, bool open) {
  if (seconds > 0) m_left += m_damping * moved.squaredNorm() / seconds + (m_left < kCredit ? kCredit / PortEnergy::kWindow * seconds : 0.0);
  m_left -= force.dot(moved);
  if (open) m_left = std::min(m_left, kCredit);
}

Vec3 EnergyTank::limit(const Vec3& force, const Vec3& velocity, double seconds) {
  m_cut = false;
  const double way = velocity.norm() * seconds;
  if (!(way > 0)) return force;
  const double work = force.dot(velocity) * seconds, allowed = std::max(0.0, m_left);
  if (!(work > allowed)) return force;
  m_cut = true;
  return force - (work - allowed) / (way * way) * seconds * velocity;
}

}  // namespace glenoid
