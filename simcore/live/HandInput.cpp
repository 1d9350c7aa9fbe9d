// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/live/HandInput.h"

#include <algorithm>

#include "simcore/base/Turns.h"

namespace glenoid {

Pose approach(const Pose& from, const Pose& to, double distanceMax, double angleMax) {
  Pose result = to;
  const Vec3 way = to.p_WB - from.p_WB;
  const double distance = way.norm();
  if (distance > distanceMax) result.p_WB = from.p_WB + way * (distanceMax / distance);
  const double angle = turnBetween(from.q_WB, to.q_WB);
  if (angle > angleMax) result.q_WB = turnTowards(from.q_WB, to.q_WB, angleMax / angle);
  return result;
}

void HandInput::bind(const Scenario& scenario, std::shared_ptr<const Recording> recording) {
  m_recording = std::move(recording);
  m_followers.clear();
  for (const Tool& tool : scenario.tools) {
    Follower follower{tool.id, nullptr, false};
    if (m_recording) {
      for (const HandTrack& track : m_recording->tracks) {
        if (track.tool == tool.id && !track.keys.empty()) follower.track = &track;
      }
    }
    m_followers.push_back(follower);
  }
}

void HandInput::restart(const Scenario& scenario, std::shared_ptr<const Recording> recording) {
  bind(scenario, std::move(recording));
  m_hands.clear();
  for (const Tool& tool : scenario.tools) m_hands.push_back(tool.home);
}

void HandInput::change(const Scenario& scenario, std::shared_ptr<const Recording> recording) {
  const std::vector<Follower> followers = m_followers;
  const std::vector<Pose> hands = m_hands;
  const bool samePath = recording == m_recording;
  restart(scenario, std::move(recording));
  for (std::size_t i = 0; i < m_followers.size(); ++i) {
    for (std::size_t old = 0; old < followers.size(); ++old) {
      if (followers[old].tool != m_followers[i].tool) continue;
      m_hands[i] = hands[old];
      m_followers[i].gliding = followers[old].gliding || !samePath;  // the hand may be off another recording's path
    }
  }
}

bool HandInput::onPath() const {
  return m_recording != nullptr && std::none_of(m_followers.begin(), m_followers.end(), [](const Follower& f) { return f.gliding; });
}

const std::vector<Pose>& HandInput::advance(const std::vector<HandWish>& wishes, double time, double dt) {
  for (std::size_t i = 0; i < m_hands.size(); ++i) {
    Follower& follower = m_followers[i];
    if (i < wishes.size() && wishes[i].held) {
      m_hands[i] = approach(m_hands[i], wishes[i].hand, kHeldSpeed * dt, kHeldTurnSpeed * dt);
      follower.gliding = true;
    } else if (follower.track != nullptr) {
      const Pose target = handAt(*follower.track, time);
      if (!follower.gliding) {
        m_hands[i] = target;
        continue;
      }
      m_hands[i] = approach(m_hands[i], target, kGlideSpeed * dt, kGlideTurnSpeed * dt);
      follower.gliding = m_hands[i].p_WB != target.p_WB || !m_hands[i].q_WB.isApprox(target.q_WB, 0.0);
    }
  }
  return m_hands;
}

}  // namespace glenoid
