// SPDX-License-Identifier: GPL-3.0-or-later
// Steps of a small scene that holds something for every effect, with a finger in its tissue: for each effect once with it switched off, once
// in a scene that never had anything for it to act on, and once with it on. Under callgrind each stretch is a
// dump of its own, named "EFFECT FORM".
#include <valgrind/callgrind.h>

#include <cstdio>
#include <string>

#include "simcore/step/Stepper.h"
#include "tests/scenes/EffectScenes.h"

using namespace glenoid;

int main() {
  constexpr int kWarmUp = 15, kCounted = 6;
  const scenes::EffectScene whole = scenes::wholeScene();
  const Inputs inputs{{scenes::pressedHand()}};
  for (const char* effect : scenes::kStepEffects)
    for (const auto& [form, name] :
         {std::pair(scenes::EffectForm::Off, "off"), std::pair(scenes::EffectForm::Never, "never"),
          std::pair(scenes::EffectForm::On, "on")}) {
      const scenes::EffectScene scene = scenes::effectScene(whole.joint, whole.scenario, effect, form);
      const auto model = compileModel(scene.joint, scene.scenario);
      if (!model || (*model)->effectOn(effect) != (form == scenes::EffectForm::On)) {
        std::fprintf(stderr, "%s is not what it should be\n", effect);
        return 2;
      }
      Stepper stepper(*model, {});
      State state = (*model)->start;
      for (int s = 0; s < kWarmUp; ++s) stepper.step(inputs, state);
      CALLGRIND_START_INSTRUMENTATION;
      CALLGRIND_ZERO_STATS;
      for (int s = 0; s < kCounted; ++s) stepper.step(inputs, state);
      CALLGRIND_STOP_INSTRUMENTATION;
      const std::string label = std::string(effect) + " " + name;
      CALLGRIND_DUMP_STATS_AT(label.c_str());
      std::printf("%s state %s\n", label.c_str(), toHex(stateHash(state)).c_str());
    }
}
