// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/scene/Recording.h"
#include "simcore/scene/Scenario.h"

namespace glenoid {

/// Keeps what hands did since a run began, step by step, so that `glenoid replay` takes the same steps again, to the same bits.
/// A key stands at the end of each step in which a hand moved, and at both ends of a rest.
class SessionRecorder {
 public:
  /// From a model's start.
  void restart(const Scenario& scenario);
  /// The model changed under way: what went before cannot be repeated from a file. No longer whole.
  void interrupt() { m_whole = false; }
  /// `step`: its number, from 1; `hands`: at its end, by tool order.
  void add(long step, const std::vector<Pose>& hands);

  bool isWhole() const { return m_whole; }
  long steps() const { return m_steps; }
  /// dt, seed, steps and tracks; the rest is the caller's.
  Recording recording() const;

 private:
  double m_dt = 0;
  unsigned m_seed = 1;
  long m_steps = 0;
  bool m_whole = false;
  std::vector<HandTrack> m_tracks;  ///< by tool, each begins at home
};

}  // namespace glenoid
