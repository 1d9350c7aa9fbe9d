// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/step/EffectPlan.h"

namespace glenoid {

namespace {
EffectPlan plan(const char* name, Wish wish, bool grounds) {
  switch (wish) {
    case Wish::On: return {name, grounds, grounds ? "asked-on" : "nothing-to-act-on"};
    case Wish::Off: return {name, false, "asked-off"};
    case Wish::Auto: break;
  }
  return {name, grounds, grounds ? "auto-present" : "nothing-to-act-on"};
}
EffectPlan notBuilt(const char* name, Wish wish) {
  return {name, false, wish == Wish::Off ? "asked-off" : "not-built"};
}
}  // namespace

std::vector<EffectPlan> planEffects(const Effects& wish, const EffectGrounds& grounds) {
  return {plan("gravity", wish.gravity, grounds.gravity),
          plan("couplings", wish.couplings, grounds.couplings),
          plan("contact", wish.contact, grounds.contact),
          plan("selfContact", wish.selfContact, grounds.selfContact),
          plan("friction", wish.friction, grounds.friction),
          plan("damping", wish.damping, grounds.damping),
          plan("bursa", wish.bursa, grounds.bursa),
          plan("dent", wish.dent, grounds.dent),
          notBuilt("haptics", wish.haptics)};
}

bool Model::effectOn(const std::string& name) const {
  for (const EffectPlan& effect : effects)
    if (effect.name == name) return effect.on;
  return false;
}

}  // namespace glenoid
