// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/HapticRecorded.h"

#include <algorithm>
#include <cmath>

#include "simcore/base/ThreadClock.h"
#include "simcore/haptic/HapticLoop.h"
#include "simcore/live/Pacer.h"
#include "simcore/step/LocalPublisher.h"

namespace glenoid {

namespace {

struct Felt {
  int tool = -1;
  HapticLoop loop;
  LocalProblem coming, known;
  LocalProxy exact;
  std::vector<Vec3> forces, exactForces;
};

std::int64_t ns(double seconds) { return static_cast<std::int64_t>(std::llround(1e9 * seconds)); }

RecordedFeel judge(const Felt& felt, const StudyScene& scene, double seconds, bool compared) {
  RecordedFeel answer;
  answer.tool = scene.scenario.tools[static_cast<std::size_t>(felt.tool)].id;
  answer.seconds = seconds;
  const HapticCounts& counts = felt.loop.counts();
  answer.forceMax = counts.forceMax;
  answer.energyMade = counts.energyMax;
  answer.heldBack = counts.heldBack;
  answer.silent = counts.silent;
  answer.rowsMax = counts.rowsMax;
  answer.overflowMax = counts.overflowMax;
  std::vector<double> errors;
  double error = 0, scale = 0;
  for (std::size_t k = 0; k < felt.forces.size(); ++k) {
    if (felt.forces[k].isZero(0) && felt.exactForces[k].isZero(0)) continue;
    errors.push_back((felt.forces[k] - felt.exactForces[k]).norm());
    error += errors.back() * errors.back();
    scale += felt.exactForces[k].squaredNorm();
  }
  if (errors.empty() || !compared) return answer;
  const auto count = static_cast<double>(errors.size());
  answer.forceError = std::sqrt(error / count);
  answer.forceRms = std::sqrt(scale / count);
  std::nth_element(errors.begin(), errors.begin() + static_cast<long>(errors.size() / 2), errors.end());
  answer.steadyError = errors[errors.size() / 2];
  return answer;
}

}  // namespace

Result<std::vector<RecordedFeel>> feelRecording(const StudyScene& scene, const DeviceProfile& device, double seconds,
                                                const std::function<bool(double)>& progress, const Silences& silences) {
  const double period = 1 / device.rate, dt = scene.scenario.dt;
  const auto model = compileModel(scene.joint, scene.scenario);
  if (!model) return model.error();
  Scenario fineScenario = scene.scenario;
  fineScenario.dt = period;
  const auto fine = compileModel(scene.joint, fineScenario);
  if (!fine) return fine.error();
  std::vector<Felt> hands;
  HapticSettings settings{device, device.rate, 0};
  settings.device.forceMax = 1e3;  // what clamps do is not what is looked at here
  settings.device.slewMax = 1e9;
  for (std::size_t tool = 0; tool < scene.scenario.tools.size(); ++tool)
    if (scene.scenario.tools[tool].link.empty()) hands.push_back({static_cast<int>(tool), HapticLoop(settings), {}, {}, {}, {}, {}});

  Stepper stepper(*model, {scene.scenario.profile}), exact(*fine, {scene.scenario.profile});
  LocalPublisher publisher(stepper, LocalProblem::kStepsAhead), exactPublisher(exact);
  State state = (*model)->start, exactState = (*fine)->start;
  Inputs inputs, exactInputs;
  LocalProblem problem;
  double publishMs = 0, tickMs = 0;
  long steps = 0;
  const bool late = silences.every > 0;
  double behind = 0, waited = 0;
  const long ticks = std::lround(seconds / period), every = std::max(1L, std::lround(dt / period));
  for (long k = 0; k < ticks; ++k) {
    const double time = static_cast<double>(k) * period;
    const double stood = late ? std::fmod(time, silences.every) - (silences.every - silences.length) : -1;
    if (stood > Pacer::kCatchUpSteps * dt) behind += period;
    waited = std::min(behind, waited + 0.5 * period);
    handsAt(scene.scenario, &scene.input, time - waited, exactInputs.hands);
    if (k % every == 0 && stood < 0) {
      inputs.hands = exactInputs.hands;
      const StepReport& step = stepper.step(inputs, state);
      const double begin = threadCpuMs();
      publisher.stepped(step);
      for (Felt& felt : hands) {
        felt.known = felt.coming;  // of the step that began Δt ago
        publisher.read(state, felt.tool, felt.coming);
        felt.coming.stamp = ns(time);
      }
      publishMs += threadCpuMs() - begin;
      ++steps;
    }
    if (!late) exactPublisher.stepped(exact.step(exactInputs, exactState));
    for (Felt& felt : hands) {
      const Pose& hand = exactInputs.hands[static_cast<std::size_t>(felt.tool)];
      ToolInput input;
      input.pose = hand;
      input.stamp = ns(time);
      const double begin = threadCpuMs();
      felt.forces.push_back(felt.loop.tick(ns(time), period, true, input, felt.known).force);
      tickMs += threadCpuMs() - begin;
      felt.exactForces.push_back(Vec3::Zero());
      if (late) continue;
      exactPublisher.read(exactState, felt.tool, problem);
      const CouplingGains gains = gainsFor(device, problem.stiffness, device.rate);
      felt.exactForces.back() = felt.exact.solve(problem, hand, {gains.stiffness, gains.damping, problem.angularStiffness, 0}, period, 0).force;
    }
    if (progress && k % 100 == 0 && !progress(static_cast<double>(k) / static_cast<double>(ticks))) return Error{Fault::Cancelled, {}, {}, "bench haptics"};
  }
  std::vector<RecordedFeel> answers;
  for (const Felt& felt : hands) {
    RecordedFeel& answer = answers.emplace_back(judge(felt, scene, seconds, !late));
    answer.publishMs = steps > 0 ? publishMs / static_cast<double>(steps) : 0;
    answer.tickUs = 1e3 * tickMs / static_cast<double>(std::max(1L, ticks) * static_cast<long>(hands.size()));
  }
  return answers;
}

}  // namespace glenoid
