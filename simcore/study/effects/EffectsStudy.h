// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "simcore/live/RunReport.h"
#include "simcore/step/EffectFacts.h"
#include "simcore/study/accuracy/AccuracyErrors.h"
#include "simcore/study/effects/EffectVariants.h"

namespace glenoid {

/// How thorough a study is.
struct EffectsOptions {
  WindowWishes windows;  ///< grid: 0: four of the scene's steps
  int repeats = 7;       ///< of the timing, interleaved
  int stepsTimed = 3;    ///< a repeat takes so many from a window's state, after one that is not counted
  int finer = 4;         ///< into how many parts a step is cut for what the scene's own steps leave out
  std::vector<std::string> only;         ///< names of effects; empty: all
  std::function<bool(double)> progress;  ///< false cancels
};
/// Within five minutes for a scene of the shoulder's size.
EffectsOptions quickEffects();

/// A moment at which an effect is missed most: what is shown of it.
struct EffectMoment {
  std::size_t window = 0;       ///< it is that window's end
  State with;                   ///< with the effect
  std::vector<DentView> dents;  ///< likewise
  std::vector<std::vector<float>>
      apart;  ///< m, by object and vertex of its visual surface: how far off it is without
};

/// What a scene would lose without an effect, over the same time from the same states. Differences are those
/// of errorsOf: root mean squares over windows and looks, of the part, pair or tool for which they are
/// largest.
struct EffectLoss {
  AccuracyErrors apart;
  double deepestWith = 0,
         deepestWithout = 0;  ///< m, of the collision surfaces of all pairs that may touch in the scene
  std::string whereWith, whereWithout;
  double handWith = 0, handWithout = 0;  ///< N, the largest force on a hand
  long steps = 0, notTaken = 0;          ///< without it; those that were not finite
  EffectMoment moment;
};

struct EffectTimes {
  std::array<Timing, kEffectChoices>
      step;  ///< ms, thread CPU time of a step and of what the effect adds after it
  /// Differences of two steps of one repeat that start from one state, ms: with less without, and `auto` less
  /// whichever of both it is, which is the same code and tells what the machine's noise is.
  Timing price, noise;
  long pairs = 0;  ///< of steps behind each difference
};

struct EffectRow {
  std::string name;
  Wish wish = Wish::Auto;       ///< of the scene
  EffectFacts automatic, on;    ///< what `auto` and what `on` make of it
  std::optional<Error> failed;  ///< why `on`, `off` or `auto` could not be compiled
  bool acts = false;  ///< `on` finds something; else there is nothing to measure: both are the same step
  std::vector<std::string> with;  ///< effects that go off with it
  std::optional<EffectTimes> times;
  std::optional<EffectLoss> loss;
};

struct EffectsResult {
  std::shared_ptr<const Model> base;  ///< the scene as it is
  std::vector<EffectRow> rows;        ///< in the order of Model::effects
  std::vector<AccuracyWindow> windows;
  WindowWishes wishes;
  /// What the scene in its own steps differs from itself in finer ones over the same windows: a loss below it
  /// is less than what the step itself leaves out.
  AccuracyErrors floor;
  int repeats = 0;
  bool hands = false;
  Timing step;  ///< ms, of the scene as it is, over all that were timed
};

/// Measures by runs with and without each effect that start from common saved states, interleaved; no clock
/// of a stage comes in. Losses are a function of scene, options, build and instruction set; times are the
/// machine's. Fails as compileModel does for the scene itself, as findWindows does, with UnknownId for an
/// effect that is not there, and with Cancelled.
Result<EffectsResult> studyEffects(const StudyScene& scene, const EffectsOptions& options);

}  // namespace glenoid
