// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <memory>

#include "simcore/live/RunReport.h"
#include "simcore/step/Stepper.h"

namespace glenoid {

/// How often one step is repeated.
struct Repeats {
  int warmUp = 20, measured = 1000;
  double secondsMax = 20;  ///< stops measuring after this, but never before three steps
};

/// What one step from one state costs, taken again and again from that same state.
struct StepCost {
  long repeats = 0;
  Timing cpu, wall, solve;                    ///< ms; solve: the stages that isSolve names
  std::array<Timing, kStageCount> stages{};   ///< thread CPU time, ms
  int contacts = 0, pressing = 0, contactIslands = 0;
  bool taken = true;
  double residual = 0, complementarity = 0;   ///< as in StepReport
  PaperReport paper;
  double memoryMiB = 0;                       ///< of the process in RAM, with one stepper at work
  State after;                                ///< of the last repetition; all are alike, bit by bit
};

/// The solve alone: everything but surfaces, collision detection, building rows and moving on.
constexpr bool isSolve(Stage stage) {
  return stage == Stage::Assemble || stage == Stage::Factor || stage == Stage::Unconstrained || stage == Stage::Delassus ||
         stage == Stage::Contact;
}

/// Restores the state before every repetition, outside the time taken. The same memory is used every time, so caches
/// are as warm as in a run and the branch predictor somewhat better trained.
StepCost measureStep(std::shared_ptr<const Model> model, const StepperOptions& options, const State& start,
                     const Inputs& inputs, const Repeats& repeats);

/// ‖v − v_ref‖ / ‖v_ref‖ over all velocities of the scene.
double relativeVelocityError(const State& state, const State& reference);

}  // namespace glenoid
