// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <string>

#include "simcore/scene/Joint.h"
#include "simcore/scene/Scenario.h"

namespace glenoid::scenes {

/// A scene with one effect switched off, one that holds nothing for it to act on, and one with it at work.
enum class EffectForm { Off, Never, On };

struct EffectScene {
  Joint joint;
  Scenario scenario;
};

/// A small scene that holds something for every effect of a step: a soft block glued to a fixed plate, a soft slab on a bursa over it, both rough and
/// damped, and a finger above the slab, which knows how it gives under a tip. The hand of `pressedHand` pushes the slab down and aside.
EffectScene wholeScene();
Pose pressedHand();

/// Effects of a step.
inline constexpr std::array<const char*, 8> kStepEffects{"gravity",  "couplings", "contact", "selfContact",
                                                         "friction", "damping",   "bursa",   "dent"};

/// From a scene with parts, couplings, bursae, dents and tools. All three forms of one effect are alike but for that
/// effect: what would differ by the way is taken from all of them (dents, whose tables hold for the joint as it is; the
/// second of two tools, which no exclusion keeps from the first; contact of coupled parts, which leaves out triangles near
/// their coupling; friction where gravity is compared, since that scales where its solve ends).
EffectScene effectScene(Joint joint, Scenario scenario, const std::string& effect, EffectForm form);

}  // namespace glenoid::scenes
