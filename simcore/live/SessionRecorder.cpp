// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/live/SessionRecorder.h"

namespace glenoid {
namespace {

bool same(const Pose& a, const Pose& b) { return a.p_WB == b.p_WB && a.q_WB.coeffs() == b.q_WB.coeffs(); }

}  // namespace

void SessionRecorder::restart(const Scenario& scenario) {
  m_dt = scenario.dt;
  m_seed = scenario.seed;
  m_steps = 0;
  m_whole = true;
  m_tracks.clear();
  for (const Tool& tool : scenario.tools) m_tracks.push_back({tool.id, {{0, tool.home}}});
}

void SessionRecorder::add(long step, const std::vector<Pose>& hands) {
  m_steps = step;
  if (!m_whole) return;
  const double time = static_cast<double>(step) * m_dt;  // as a run without a window asks for hands
  for (std::size_t i = 0; i < m_tracks.size() && i < hands.size(); ++i) {
    std::vector<HandKey>& keys = m_tracks[i].keys;
    const std::size_t count = keys.size();
    const bool rests = count > 1 && same(keys[count - 1].hand, hands[i]) && same(keys[count - 2].hand, hands[i]);
    if (rests) keys.back().time = time;
    else keys.push_back({time, hands[i]});
  }
}

Recording SessionRecorder::recording() const {
  Recording recording;
  recording.dt = m_dt;
  recording.seed = m_seed;
  recording.steps = m_steps;
  recording.tracks = m_tracks;
  return recording;
}

}  // namespace glenoid
