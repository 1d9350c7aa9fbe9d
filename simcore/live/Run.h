// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "simcore/base/Error.h"
#include "simcore/collide/Penetration.h"
#include "simcore/live/RunHaptics.h"
#include "simcore/live/RunReport.h"
#include "simcore/scene/Recording.h"
#include "simcore/step/Stepper.h"

namespace glenoid {

class TrainingWatch;

/// How a scenario is run from its start without anybody at the tools.
struct RunOptions {
  double seconds = 0;               ///< s of simulated time, rounded to whole steps; used when steps is 0
  long steps = 0;                   ///< 1…kRunStepsMax; 0: from `seconds`
  StepperOptions stepper;
  const Recording* input = nullptr; ///< hands over time; null: they stay at home
  bool trainingTrace = false;       ///< answer the table that the training's metrics are made of
  bool record = false;              ///< answer a recording that `replay --check` can repeat
  double timeLimit = 0;             ///< s of the clock: a run that takes longer ends after the step at hand, with a notice TimeUp; 0: none
  bool realtime = false;            ///< wait for the clock; a late run catches up by a few steps, then slows down
  std::optional<HapticWishes> haptic;  ///< with `realtime`: what it is felt with; nothing: not felt
  bool checks = true;               ///< penetration on collision and visual surfaces, outside the step's time
  std::optional<double> failDepth;  ///< m: deeper is a notice TooDeep; infinite: never; nothing: PenetrationProbe's own limits
  int visualEvery = 50;             ///< steps between two checks of the visual surfaces; 0: never
  /// After every step, outside its time; for traces. `depths`: how deep each pair of the model lies, as the report's
  /// penetration is measured; empty without checks.
  std::function<void(const StepReport& step, const State& state, std::span<const Penetration> depths)> observe;
  /// Likewise, of a scenario with tasks.
  std::function<void(const TrainingWatch& training, double time)> observeTraining;
  std::function<bool(double fraction)> progress;  ///< after every step, 0…1; false cancels
  std::function<bool(double fraction)> compareProgress;  ///< of the comparison that follows a run that was felt; false ends that
};

/// Beyond this, the times of all steps would fill the memory.
inline constexpr long kRunStepsMax = 5'000'000;

struct RunResult {
  RunReport report;                    ///< `scenario` is the scenario's id; the caller may put what was asked for
  State state;                         ///< at the end
  std::vector<ContactView> contacts;   ///< of the last step, for a picture
  std::vector<DentView> dents;         ///< likewise
  std::string trainingTrace;           ///< TrainingWatch::csv(), when asked for and the scenario has tasks
  std::optional<Recording> recording;  ///< when asked for; its `scenario` likewise
};

/// Where each hand is at a time, in the scenario's tool order; a tool without a track stays at home.
/// Allocates nothing once `hands` has its size.
void handsAt(const Scenario& scenario, const Recording* input, double time, std::vector<Pose>& hands);

/// How long the hands of a recording are busy: its last key or the end of its last mark, s; 0 without either.
double inputSeconds(const Recording& input);

/// Runs from model->start. A function of model, input and options' stepper: same bits for any number of threads.
/// Fails with OutOfRange (steps), UnknownId (a track of a tool that is not there, naming it), Unusable (a track
/// without keys) or Cancelled. Steps that are not finite are no failure: the report counts them.
Result<RunResult> runScenario(std::shared_ptr<const Model> model, const RunOptions& options);

}  // namespace glenoid
