// SPDX-License-Identifier: GPL-3.0-or-later
// Apart from SimulationThread.cpp, so that a test of the threads needs no solver.
#include "simcore/live/SimulationThread.h"

namespace glenoid {

StepFunction makeStepperStep(std::shared_ptr<const Model> model, const StepperOptions& options) {
  const auto stepper = std::make_shared<Stepper>(std::move(model), options);
  return [stepper](const Inputs& inputs, State& state) -> const StepReport& { return stepper->step(inputs, state); };
}

}  // namespace glenoid
