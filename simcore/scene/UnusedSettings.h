// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "simcore/scene/Joint.h"
#include "simcore/scene/Scenario.h"

namespace glenoid {

/// A wish of a scenario that changes nothing in this version or in this scene.
struct UnusedSetting {
  enum class Why {
    NotBuilt,    ///< an effect that is switched on and that no version has built yet
    LoadRise,    ///< a time for loads to rise without any load
    Seed,        ///< a seed other than the default, while nothing is drawn at random
  };
  Why why = Why::NotBuilt;
  std::string name;  ///< of the effect; the seed, the time in s in digits
};

/// "not-built", "load-rise", "seed".
const char* unusedName(UnusedSetting::Why why);

/// The effects that this version knows by name and has not built.
const std::vector<std::string>& effectsNotBuilt();

/// In the scenario's order. A hold of or a load on a fixed part is not among them: checkScenario refuses it.
std::vector<UnusedSetting> unusedSettings(const Scenario& scenario);

}  // namespace glenoid
