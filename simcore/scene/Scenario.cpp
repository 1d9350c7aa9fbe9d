// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/scene/Scenario.h"

#include <algorithm>
#include <cassert>

#include "simcore/base/Turns.h"

namespace glenoid {

int findTool(const Scenario& scenario, const std::string& id) {
  for (std::size_t i = 0; i < scenario.tools.size(); ++i)
    if (scenario.tools[i].id == id) return static_cast<int>(i);
  return -1;
}

double loadShareAt(const Scenario& scenario, double time) {
  return scenario.loadRise > 0 ? std::clamp(time / scenario.loadRise, 0.0, 1.0) : 1;
}

Pose motionAt(const Motion& motion, double time) {
  assert(!motion.keys.empty());
  const auto after = std::upper_bound(motion.keys.begin(), motion.keys.end(), time,
                                      [](double t, const MotionKey& key) { return t < key.time; });
  MotionKey now = after == motion.keys.begin() ? *after : *(after - 1);
  if (after != motion.keys.begin() && after != motion.keys.end()) {
    const double s = (time - now.time) / (after->time - now.time);
    now.displacement_W += s * (after->displacement_W - now.displacement_W);
    now.turn_W = turnTowards(now.turn_W, after->turn_W, s);
  }
  return {motion.centre_W + now.displacement_W - now.turn_W * motion.centre_W, now.turn_W};
}

void dropActionsOn(Scenario& scenario, const std::string& part, const std::string& region) {
  const auto onRegion = [&](const auto& item) { return item.part == part && (region.empty() || item.region == region); };
  std::erase_if(scenario.pressures, onRegion);
  std::erase_if(scenario.supports, onRegion);
  if (!region.empty()) return;
  const auto drop = [&](auto& list) { std::erase_if(list, [&](const auto& item) { return item.part == part; }); };
  drop(scenario.holds);
  drop(scenario.loads);
  drop(scenario.motions);
  std::erase(scenario.selfContactParts, part);
}

}  // namespace glenoid
