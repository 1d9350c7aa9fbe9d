// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/haptic/HapticLoop.h"

#include <algorithm>
#include <limits>

#include "simcore/tool/PoseSpring.h"

namespace glenoid {

namespace {

GuardLimits limitsOf(const DeviceProfile& device) {
  GuardLimits limits;
  limits.forceMax = device.forceMax;
  limits.slewMax = device.slewMax;
  return limits;
}

}  // namespace

HapticLoop::HapticLoop(const HapticSettings& settings)
    : m_settings(settings),
      m_guard(limitsOf(settings.device)),
      m_handle(settings.device.damping, 1 / settings.rate),
      m_alone(0, 1 / settings.rate),
      m_tank(settings.device.damping, settings.device.mass) {}

HapticLoop::Answer HapticLoop::tick(std::int64_t now, double T, bool present, const ToolInput& input, const LocalProblem& problem) {
  const double gone = std::numeric_limits<double>::infinity();
  ++m_counts.ticks;
  m_time += T;
  const bool pose = present && isHandPose(input.pose);
  const bool jumped = pose && m_seen && (input.pose.p_WB - m_lastHand.p_WB).norm() > kWildJump;
  m_doubt = pose && !jumped ? std::max(0, m_doubt - 1) : kTrustAfter + 1;
  const bool believed = m_doubt == 0;
  const double dataAge = believed ? 1e-9 * static_cast<double>(now - input.stamp) : gone;
  const double age = problem.valid ? 1e-9 * static_cast<double>(now - problem.stamp) : 0.0;

  Vec3 moved = Vec3::Zero();
  if (pose && m_seen && !jumped) {
    moved = input.pose.p_WB - m_lastHand.p_WB;
    m_handle.add(m_guard.shown(), moved, T, m_open);
    m_alone.add(m_guard.shown(), moved, T, m_open);
    m_tank.add(m_guard.shown(), moved, T, m_open);
  }
  if (problem.valid && problem.stiffness != m_wishedStiffness) {
    m_wishedStiffness = problem.stiffness;
    m_counts.gains = gainsFor(m_settings.device, problem.stiffness, m_settings.rate, m_settings.addedDelay);
  }

  ProxyForce felt;
  if (believed) {
    const ProxyGains gains{m_counts.gains.stiffness, m_counts.gains.damping, problem.angularStiffness, 0};
    felt = m_proxy.solve(problem, input.pose, gains, T, age);
  } else {
    m_proxy.forget();
  }
  if (pose) m_lastHand = input.pose;  // where a hand comes back is where it goes on from
  m_seen = pose;

  Answer answer;
  answer.force = m_tank.limit(m_guard.show(felt.force, dataAge, age, problem.dt, T), moved / T, T);
  m_guard.showed(answer.force);
  // What a device did while it was not believed nobody knows: it begins anew.
  m_open = answer.force.norm() < PortEnergy::kNoForce && (!believed || felt.force.norm() < PortEnergy::kNoForce);
  m_counts.heldBack += m_tank.cut();
  const double kept = felt.force.norm() > 0 ? std::min(1.0, answer.force.norm() / felt.force.norm()) : 0.0;
  answer.torque = kept * felt.torque;

  const GuardWord& word = m_counts.word = m_guard.word();
  m_counts.clamped += word.clamped || felt.cut;
  m_counts.slewed += word.slewed;
  m_counts.lost += word.lost;
  if (!word.lost && believed) {
    ++m_counts.heard;
    m_believedHand = input.pose;
  } else if (m_counts.heard > 0 && word.lost && m_counts.lostOnceHeard++ == 0) {
    m_counts.lostFrom = m_time;
  }
  m_counts.silent += word.silent;
  m_counts.inexact += !felt.exact;
  m_counts.rows = problem.valid ? problem.rowCount : 0;
  m_counts.rowsMax = std::max(m_counts.rowsMax, m_counts.rows);
  if (problem.valid && problem.overflow > 0) {
    ++m_counts.overflow;
    m_counts.overflowMax = std::max(m_counts.overflowMax, problem.overflow);
  }
  m_counts.force = answer.force;
  m_counts.forceMax = std::max(m_counts.forceMax, answer.force.norm());
  m_counts.energyMax = m_handle.worst();
  m_counts.loopEnergyMax = m_alone.worst();
  m_counts.problemAge = age;
  m_counts.problemAgeMax = std::max(m_counts.problemAgeMax, age);
  if (m_logged < m_log.size()) m_log[m_logged++] = {now, input.pose.p_WB, felt.force, answer.force};
  return answer;
}

}  // namespace glenoid
