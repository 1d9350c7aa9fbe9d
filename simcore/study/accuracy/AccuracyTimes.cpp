// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/accuracy/AccuracyTimes.h"

#include <algorithm>

namespace glenoid {
namespace {

/// Of one setting.
struct Sampler {
  std::vector<State> states;  ///< of the windows that it is timed in
  std::vector<float> cpu, wall;
};

void takeSteps(AccuracyPlayer& player, const State& start, int steps, Sampler& sampler) {
  State state = start;
  for (int s = 0; s <= steps; ++s) {
    const StepReport& report = player.stepper().step(player.inputsAt(state), state);
    if (s == 0) continue;  // brings memory and guesses up
    sampler.cpu.push_back(static_cast<float>(report.stepCpuMs));
    sampler.wall.push_back(static_cast<float>(report.stepWallMs));
  }
}

StepTimes timesOf(Sampler sampler) {
  StepTimes times;
  times.count = static_cast<long>(sampler.cpu.size());
  if (times.count == 0) return times;
  times.cpu = timingOf(sampler.cpu);
  times.wall = timingOf(sampler.wall);
  return times;
}

}  // namespace

std::vector<StepTimes> timeInterleaved(std::span<const std::unique_ptr<AccuracyPlayer>> players, std::span<const AccuracyWindow> windows,
                                       const AccuracyOptions& options, const std::function<bool(double)>& progress,
                                       const std::function<void(std::span<const StepTimes>)>& soFar) {
  std::vector<Sampler> samplers(players.size());
  const auto allTimes = [&] {
    std::vector<StepTimes> times;
    for (const Sampler& sampler : samplers) times.push_back(timesOf(sampler));
    return times;
  };
  for (int repeat = 0; repeat < options.repeats; ++repeat) {
    for (std::size_t k = 0; k < players.size(); ++k) {
      if (!progress(static_cast<double>(repeat * static_cast<int>(players.size()) + static_cast<int>(k)) /
                    static_cast<double>(options.repeats * static_cast<int>(players.size()))))
        return {};
      if (!players[k]) continue;
      Sampler& sampler = samplers[k];
      if (repeat == 0) {
        // The first window says how many the time is enough for.
        Sampler trial;
        takeSteps(*players[k], players[k]->begin(windows[windows.size() / 2]), 1, trial);
        const double each = 1e-3 * static_cast<double>(trial.wall.front()) * (options.stepsTimed + 1);
        const auto most = static_cast<std::size_t>(std::clamp(options.secondsTimed / std::max(each, 1e-6), 1.0, static_cast<double>(windows.size())));
        for (std::size_t w = 0; w < most; ++w) sampler.states.push_back(players[k]->begin(windows[(2 * w + 1) * windows.size() / (2 * most)]));
      }
      for (const State& state : sampler.states) takeSteps(*players[k], state, options.stepsTimed, sampler);
    }
    if (soFar && repeat + 1 < options.repeats) soFar(allTimes());
  }
  return allTimes();
}

}  // namespace glenoid
