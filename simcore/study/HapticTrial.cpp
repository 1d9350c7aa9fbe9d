// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/HapticTrial.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simcore/step/LocalPublisher.h"

namespace glenoid {

namespace {

constexpr double kCycle = 2.5, kAbove = 0.003;  // s, m
const Vec3 kPlace(0.0017, 0, 0.0023);           // off the grid's lines

/// Where the hand wants to be.
Vec3 targetAt(const HapticTrial& trial, double time) {
  const double phase = std::fmod(time, kCycle), turn = std::numbers::pi;
  const auto rise = [&](double from, double length) { return 0.5 - 0.5 * std::cos(turn * std::clamp((phase - from) / length, 0.0, 1.0)); };
  const double in = rise(0, 0.75) - rise(1.25, 0.75);
  Vec3 target = kPlace;
  target.y() = kAbove - (kAbove + trial.depth) * in;
  if (static_cast<long>(time / kCycle) % 2 == 1) target.x() += 0.010 * (rise(0.75, 0.4) - rise(2.0, 0.4));
  return target;
}

}  // namespace

Result<std::vector<Vec3>> exactHapticForces(HapticSurface surface, const CouplingGains& gains, double period, const std::vector<Vec3>& path) {
  if (path.empty()) return std::vector<Vec3>{};
  const auto model = makeHapticScene(surface, gains.stiffness, period, path.front());
  if (!model) return model.error();
  Stepper stepper(*model, {});
  LocalPublisher publisher(stepper);
  State state = (*model)->start;
  Inputs inputs;
  inputs.hands = {(*model)->scenario.tools[0].home};
  LocalProblem problem;
  LocalProxy proxy;
  std::vector<Vec3> forces(path.size(), Vec3::Zero());
  for (std::size_t k = 1; k < path.size(); ++k) {
    inputs.hands[0].p_WB = path[k];
    publisher.stepped(stepper.step(inputs, state));
    publisher.read(state, 0, problem);
    forces[k] = proxy.solve(problem, inputs.hands[0], {gains.stiffness, gains.damping, problem.angularStiffness, 0}, period, 0).force;
  }
  return forces;
}

Result<HapticTrialResult> runHapticTrial(const HapticTrial& trial) {
  HapticTrialResult result;
  HapticSettings settings{trial.device, trial.device.rate, trial.delay};
  settings.device.forceMax = 1e3;  // what clamps do is not what is looked at here
  settings.device.slewMax = 1e9;
  const double period = 1 / settings.rate;
  result.gains = gainsFor(settings.device, trial.wishedStiffness, settings.rate, trial.delay);
  const Vec3 start = targetAt(trial, 0);
  const auto model = makeHapticScene(trial.surface, result.gains.stiffness, trial.dt, start);
  if (!model) return model.error();

  Stepper stepper(*model, {});
  LocalPublisher publisher(stepper, LocalProblem::kStepsAhead);
  State state = (*model)->start;
  Inputs inputs;
  inputs.hands = {(*model)->scenario.tools[0].home};
  HapticLoop loop(settings);
  VirtualHandSettings handSettings;
  handSettings.deviceDamping = settings.device.damping;
  handSettings.mass += settings.device.mass;
  handSettings.period = period;
  handSettings.delay = trial.delay + settings.device.delay;
  VirtualHand hand(handSettings, start);
  ToolInput input;
  input.pose = inputs.hands[0];

  LocalProblem coming, known;
  const auto ns = [&](double seconds) { return static_cast<std::int64_t>(std::llround(1e9 * seconds)); };
  const long ticks = std::lround(trial.seconds / period), every = std::lround(trial.dt / period);
  double squares = 0, stiffness = 0;
  long pressed = 0, held = 0;
  for (long k = 0; k < ticks; ++k) {
    const double time = static_cast<double>(k) * period;
    const Vec3 at = hand.position();
    const bool silent = trial.silentEvery > 0 && std::fmod(time, trial.silentEvery) >= trial.silentEvery - trial.silentFor;
    if (k % every == 0 && !silent) {
      known = coming;  // of the step that began Δt ago
      inputs.hands[0].p_WB = at;
      publisher.stepped(stepper.step(inputs, state));
      publisher.read(state, 0, coming);
      coming.stamp = ns(time);
    }
    input.pose.p_WB = at;
    input.stamp = ns(time);
    const Vec3 force = loop.tick(ns(time), period, true, input, known).force;
    result.path.push_back(at);
    result.wanted.push_back(force);
    if (!force.isZero(0)) squares += force.squaredNorm(), ++pressed;
    const double phase = std::fmod(time, kCycle);
    if (phase > 1.2 && phase < 1.25 && at.y() < 0) stiffness += force.y() / -at.y(), ++held;
    const Vec3 target = targetAt(trial, time);
    hand.tick(force, target, (targetAt(trial, time + period) - target) / period, !loop.open());
  }
  result.counts = loop.counts();
  result.energyMade = hand.energyMade();
  result.loopEnergyMade = hand.loopEnergyMade();
  result.forceMax = loop.counts().forceMax;
  result.forceRms = pressed > 0 ? std::sqrt(squares / static_cast<double>(pressed)) : 0;
  result.renderedStiffness = held > 0 ? stiffness / static_cast<double>(held) : 0;
  if (!trial.compare) return result;

  const auto exact = exactHapticForces(trial.surface, result.gains, period, result.path);
  if (!exact) return exact.error();
  double error = 0, scale = 0;
  long both = 0;
  for (std::size_t k = 0; k < exact->size(); ++k) {
    if ((*exact)[k].isZero(0) && result.wanted[k].isZero(0)) continue;
    error += (result.wanted[k] - (*exact)[k]).squaredNorm();
    scale += (*exact)[k].squaredNorm();
    ++both;
  }
  if (both > 0) result.forceError = std::sqrt(error / static_cast<double>(both));
  if (scale > 0) result.forceErrorShare = std::sqrt(error / scale);
  return result;
}

}  // namespace glenoid
