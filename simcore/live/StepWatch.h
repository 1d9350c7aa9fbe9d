// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "simcore/live/Notice.h"
#include "simcore/scene/Recording.h"
#include "simcore/step/Stepper.h"

namespace glenoid {

/// How far a run has come to rest, of its last step.
struct RestState {
  bool stepped = false;     ///< false: no step yet, and nothing below is known
  bool loadsRise = false;   ///< the loads are not whole yet
  double speed = 0;         ///< m/s, of the fastest point of any part
  bool slow = false;        ///< loads are whole and no part moves faster than RestWatch::kSlow
};

/// Looks at a run from outside, step by step, and knows what must be said about it.
class StepWatch {
 public:
  virtual ~StepWatch() = default;

  /// After every step, in the thread that steps. `onPath`: all hands are where the recording has them.
  virtual void look(const StepReport& step, const State& state, bool onPath) = 0;

  /// What is known by now, at most one notice of a kind for the same subjects. Never null; another list when something is new.
  /// From any thread.
  virtual std::shared_ptr<const std::vector<Notice>> notices() const = 0;

  /// Something that whoever steps found by itself; notices() has it from then on. In the thread that steps.
  virtual void add(const Notice& notice) = 0;

  /// In the thread that steps.
  virtual RestState rest() const { return {}; }
};

/// Makes the watch of a run that begins or goes on with a model. `input`: what hands follow, or null. `told` is called from any
/// thread when notices() has something new outside of look(); the watch lets go of it before it ends.
using WatchMaker = std::function<std::unique_ptr<StepWatch>(std::shared_ptr<const Model> model, std::shared_ptr<const Recording> input,
                                                            std::function<void()> told)>;

}  // namespace glenoid
