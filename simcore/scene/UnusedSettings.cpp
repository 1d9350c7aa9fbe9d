// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/scene/UnusedSettings.h"

#include <algorithm>

#include "simcore/scene/SceneWords.h"

namespace glenoid {

const char* unusedName(UnusedSetting::Why why) {
  switch (why) {
    case UnusedSetting::Why::NotBuilt: return "not-built";
    case UnusedSetting::Why::LoadRise: return "load-rise";
    case UnusedSetting::Why::Seed: return "seed";
  }
  return "";
}

const std::vector<std::string>& effectsNotBuilt() {
  static const std::vector<std::string> names = {"haptics"};
  return names;
}

std::vector<UnusedSetting> unusedSettings(const Scenario& scenario) {
  using Why = UnusedSetting::Why;
  std::vector<UnusedSetting> unused;
  for (const auto& [name, wish] : scene_words::kEffects)
    if (const auto& list = effectsNotBuilt(); scenario.effects.*wish == Wish::On && std::find(list.begin(), list.end(), name) != list.end())
      unused.push_back({Why::NotBuilt, std::string(name)});
  if (scenario.loadRise > 0 && scenario.loads.empty()) unused.push_back({Why::LoadRise, std::to_string(scenario.loadRise)});
  if (scenario.seed != Scenario().seed) unused.push_back({Why::Seed, std::to_string(scenario.seed)});
  return unused;
}

}  // namespace glenoid
