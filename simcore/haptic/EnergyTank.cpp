// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/haptic/EnergyTank.h"

#include <algorithm>
#include <cmath>

#include "simcore/haptic/PortEnergy.h"

namespace glenoid {

void EnergyTank::add(const Vec3& force, const Vec3& moved, double seconds, bool open) {
  if (seconds > 0) m_left += m_damping * moved.squaredNorm() / seconds + (m_left < kCredit ? kCredit / PortEnergy::kWindow * seconds : 0.0);
  m_left -= force.dot(moved);
  if (open) m_left = std::min(m_left, kCredit);
}

Vec3 EnergyTank::limit(const Vec3& force, const Vec3& velocity, double seconds) {
  m_cut = false;
  // With the share s of the force: s² square + s drive ≤ what is there.
  const double square = force.squaredNorm() * seconds * seconds / (2 * m_mass), drive = force.dot(velocity) * seconds, there = std::max(0.0, m_left);
  if (!(square + drive > there)) return force;
  m_cut = true;
  if (!(square > 0)) return Vec3::Zero();  // less than a number can square
  const double share = (std::sqrt(drive * drive + 4 * square * there) - drive) / (2 * square);
  return std::clamp(share, 0.0, 1.0) * force;
}

}  // namespace glenoid
