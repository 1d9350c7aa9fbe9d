// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/haptic/ForceGuard.h"

#include <algorithm>

namespace glenoid {

double silencePatience(double dt) { return std::max(0.020, 3 * dt); }

Vec3 ForceGuard::show(const Vec3& wanted, double dataAge, double simulationAge, double simulationDt, double T) {
  m_word = {};
  m_word.lost = !(dataAge <= m_limits.dataPatience) || !wanted.allFinite();
  m_word.silent = !(simulationAge <= silencePatience(simulationDt));
  if (m_word.lost || m_word.silent) {
    const double ramp = m_word.lost ? m_limits.dataRamp : m_limits.silenceRamp;
    if (m_rampLeft < 0) {
      m_rampFrom = m_shown;
      m_rampLeft = m_rampLength = ramp;
    } else if (m_word.lost && m_rampLeft > ramp) {  // lost as well while it fades for silence
      m_rampFrom = m_shown;
      m_rampLeft = m_rampLength = ramp;
    }
    m_rampLeft = std::max(0.0, m_rampLeft - T);
    if (m_rampLeft < 1e-9) m_rampLeft = 0;
    m_shown = m_rampLeft / m_rampLength * m_rampFrom;
    return m_shown;
  }
  if (m_rampLeft >= 0) m_back = m_rampLeft / m_rampLength;  // as far as it had gone
  m_rampLeft = -1;
  m_back = std::min(1.0, m_back + T / m_limits.comeBack);
  Vec3 aim = m_back * wanted;
  if (const double size = aim.norm(); size > m_limits.forceMax) {
    aim *= m_limits.forceMax / size;
    m_word.clamped = true;
  }
  const Vec3 change = aim - m_shown;
  if (const double size = change.norm(), most = m_limits.slewMax * T; size > most) {
    aim = m_shown + most / size * change;
    m_word.slewed = true;
  }
  m_shown = aim;
  return m_shown;
}

}  // namespace glenoid
