// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

namespace glenoid {

struct Model;

/// What one effect finds in a scene, in figures: what a sentence needs that says why it is on or off.
struct EffectFacts {
  std::string name;  ///< as in EffectPlan
  bool on = false;
  /// A word of EffectPlan; also "no-contact": contact is off, without which this effect has nothing to act
  /// on, and "run-felt": it is no part of the step but of a run in real time, which switches it on.
  std::string reason;
  struct Count {
    std::string what;
    double count = 0;
  };
  /// Always the same words in the same order for an effect, zeros too:
  ///   gravity      "movingParts", "acceleration" (m/s²)
  ///   couplings    "couplings", "springs" (of a model in which they are on)
  ///   contact      "pairs" (of objects that may touch, in a model in which it is on)
  ///   selfContact  "parts" that fold onto themselves, "softParts" that move
  ///   friction     "materials" of the joint and "tools" with a coefficient above zero
  ///   damping      "materials", "couplings" that damp
  ///   bursa        "bursae"
  ///   dent         "parts" with a table of what gives under a tip, "tools" with a round tip
  ///   haptics      "tools" that a hand holds
  std::vector<Count> counts;

  double count(const std::string& what) const {  ///< 0 where it has none of that name
    for (const Count& one : counts)
      if (one.what == what) return one.count;
    return 0;
  }
};

/// Of every effect, in the order of Model::effects.
std::vector<EffectFacts> effectFacts(const Model& model);

}  // namespace glenoid
