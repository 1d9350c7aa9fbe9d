// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/StepCost.h"

#include <chrono>

#include "simcore/study/Machine.h"

namespace glenoid {

StepCost measureStep(std::shared_ptr<const Model> model, const StepperOptions& options, const State& start,
                     const Inputs& inputs, const Repeats& repeats) {
  using Clock = std::chrono::steady_clock;
  StepCost cost;
  Stepper stepper(std::move(model), options);
  State state = start;
  const auto secondsSince = [](Clock::time_point begin) { return std::chrono::duration<double>(Clock::now() - begin).count(); };

  // A slow profile spends a tenth of its time on warming up, one step at least.
  const auto warmBegin = Clock::now();
  for (int i = 0; i < repeats.warmUp && (i == 0 || secondsSince(warmBegin) < 0.1 * repeats.secondsMax); ++i) {
    state = start;
    stepper.step(inputs, state);
  }
  std::vector<float> cpu, wall, solve;
  std::array<std::vector<float>, kStageCount> stages;
  const auto begin = Clock::now();
  for (int i = 0; i < repeats.measured && (i < 3 || secondsSince(begin) < repeats.secondsMax); ++i) {
    state = start;
    const StepReport& report = stepper.step(inputs, state);
    cpu.push_back(static_cast<float>(report.stepCpuMs));
    wall.push_back(static_cast<float>(report.stepWallMs));
    double solveMs = 0;
    for (int s = 0; s < kStageCount; ++s) {
      stages[s].push_back(static_cast<float>(report.cpuMs[s]));
      if (isSolve(static_cast<Stage>(s))) solveMs += report.cpuMs[s];
    }
    solve.push_back(static_cast<float>(solveMs));
    cost.contacts = report.contacts;
    cost.pressing = report.pressing;
    cost.contactIslands = report.contactIslands;
    cost.taken = report.taken;
    cost.residual = report.residual;
    cost.complementarity = report.complementarity;
    cost.paper = report.paper;
  }
  cost.memoryMiB = residentMiB();
  cost.repeats = static_cast<long>(cpu.size());
  cost.cpu = timingOf(cpu);
  cost.wall = timingOf(wall);
  cost.solve = timingOf(solve);
  for (int s = 0; s < kStageCount; ++s) cost.stages[s] = timingOf(stages[s]);
  cost.after = std::move(state);
  return cost;
}

double relativeVelocityError(const State& state, const State& reference) {
  const double scale = reference.v.norm();
  return scale > 0 ? (state.v - reference.v).norm() / scale : (state.v - reference.v).norm();
}

}  // namespace glenoid
