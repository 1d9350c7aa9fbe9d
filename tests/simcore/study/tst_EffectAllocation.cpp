// SPDX-License-Identifier: GPL-3.0-or-later
// An effect that is off takes nothing from the heap that a scene without it does not take, neither for a
// stepper nor for its steps, and leaves the same bits; with it on the heap is asked for more, or the state is
// another. Instructions: tests/bench/instructions.
#include <gtest/gtest.h>

#include <cstdlib>

#include "tests/scenes/EffectScenes.h"
#include "tests/simcore/step/HeapCount.h"
#include "tests/simcore/study/ShippedScene.h"

namespace glenoid::test {
namespace {

struct Taken {
  long allocations = 0;  ///< of a stepper and its steps
  long warm = 0;         ///< of the steps of a second round
  std::string hash;
  bool on = false;
};

Taken taken(const scenes::EffectScene& whole, const Inputs& inputs, const std::string& effect, scenes::EffectForm form) {
  const scenes::EffectScene scene = scenes::effectScene(whole.joint, whole.scenario, effect, form);
  const auto model = compileModel(scene.joint, scene.scenario).value();
  Taken answer;
  answer.on = model->effectOn(effect);
  State state = model->start;
  const long before = heapAllocations();
  Stepper stepper(model, {});
  for (int s = 0; s < 30; ++s) stepper.step(inputs, state);
  answer.allocations = heapAllocations() - before;
  answer.hash = toHex(stateHash(state));
  state = model->start;
  const long again = heapAllocations();
  for (int s = 0; s < 30; ++s) stepper.step(inputs, state);
  answer.warm = heapAllocations() - again;
  return answer;
}

void expectNothingTaken(const scenes::EffectScene& whole, const Inputs& inputs) {
  ASSERT_TRUE(heapIsCounted());
  taken(whole, inputs, "gravity", scenes::EffectForm::On);  // libraries ask for what they keep the first time
  for (const char* effect : scenes::kStepEffects) {
    const Taken off = taken(whole, inputs, effect, scenes::EffectForm::Off), never = taken(whole, inputs, effect, scenes::EffectForm::Never),
                on = taken(whole, inputs, effect, scenes::EffectForm::On);
    EXPECT_FALSE(off.on || never.on) << effect;
    EXPECT_TRUE(on.on) << effect;
    EXPECT_EQ(off.allocations, never.allocations) << effect;
    EXPECT_EQ(off.hash, never.hash) << effect;
    EXPECT_EQ(off.warm, never.warm) << effect;
    EXPECT_TRUE(off.hash != on.hash || on.allocations > off.allocations) << effect << " does nothing here, so the test would see nothing";
    // What has scratch of its own asks for it when it is on.
    if (const std::string name = effect; name == "contact" || name == "selfContact" || name == "bursa") {
      EXPECT_GT(on.allocations, off.allocations) << effect;
    }
    std::printf("%s: %ld allocations off, %ld never, %ld on\n", effect, off.allocations, never.allocations, on.allocations);
  }
}

TEST(EffectAllocation, whatIsOffTakesNothing) { expectNothingTaken(scenes::wholeScene(), {{scenes::pressedHand()}}); }

/// The same of the arthroscopy, with its hands in the cuff: GLENOID_LONG=1, half a minute.
TEST(EffectAllocation, whatIsOffTakesNothingOfTheShippedScene) {
  if (!std::getenv("GLENOID_LONG")) return;
  const StudyScene shipped = shippedScene();
  Inputs inputs;
  handsAt(shipped.scenario, &shipped.input, 6.5, inputs.hands);
  expectNothingTaken({shipped.joint, shipped.scenario}, inputs);
}

}  // namespace
}  // namespace glenoid::test
