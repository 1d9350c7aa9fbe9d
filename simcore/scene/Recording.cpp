// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/scene/Recording.h"

#include <algorithm>
#include <cassert>

#include "simcore/base/Turns.h"

namespace glenoid {

Pose handAt(const HandTrack& track, double time) {
  assert(!track.keys.empty());
  const auto after = std::upper_bound(track.keys.begin(), track.keys.end(), time,
                                      [](double t, const HandKey& key) { return t < key.time; });
  if (after == track.keys.begin()) return after->hand;
  const HandKey& a = *(after - 1);
  if (after == track.keys.end()) return a.hand;
  const HandKey& b = *after;
  const double s = (time - a.time) / (b.time - a.time);
  return {a.hand.p_WB + s * (b.hand.p_WB - a.hand.p_WB), turnTowards(a.hand.q_WB, b.hand.q_WB, s)};
}

}  // namespace glenoid
