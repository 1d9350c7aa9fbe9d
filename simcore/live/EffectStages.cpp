// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/live/EffectStages.h"

namespace glenoid {

const EffectStages* stagesOfEffect(const std::string& effect) {
  static const std::vector<EffectStages> table = {
      {"contact", {Stage::Surfaces, Stage::Collide, Stage::Islands, Stage::Delassus, Stage::Contact}, ""},
      {"gravity", {}, "assemble"},
      {"couplings", {}, "assemble"},
      {"damping", {}, "assemble"},
      {"friction", {Stage::Friction}, ""},
      {"bursa", {Stage::Bursa}, ""},
      {"dent", {Stage::Dent}, ""},
      {"selfContact", {Stage::SelfContact}, ""},
  };
  for (const EffectStages& one : table)
    if (effect == one.effect) return &one;
  return nullptr;
}

}  // namespace glenoid
