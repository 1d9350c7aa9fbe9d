// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/live/Run.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "simcore/live/BuildId.h"
#include "simcore/live/Pacer.h"
#include "simcore/live/PenetrationProbe.h"
#include "simcore/live/RunGather.h"
#include "simcore/live/RunWatch.h"
#include "simcore/live/TimeUp.h"
#include "simcore/train/TrainingWatch.h"

namespace glenoid {
namespace {

Result<long> stepCount(const RunOptions& options, double dt) {
  if (options.steps != 0) {
    if (options.steps > 0 && options.steps <= kRunStepsMax) return options.steps;
    return Error{Fault::OutOfRange, {}, {std::to_string(options.steps), "1", std::to_string(kRunStepsMax)}, "steps"};
  }
  const double steps = std::round(options.seconds / dt);
  if (std::isfinite(steps) && steps >= 1 && steps <= static_cast<double>(kRunStepsMax)) return static_cast<long>(steps);
  return Error{Fault::OutOfRange, {}, {std::to_string(options.seconds) + " s", std::to_string(dt) + " s",
                                      std::to_string(dt * kRunStepsMax) + " s"}, "seconds"};
}

Result<Done> checkInput(const Scenario& scenario, const Recording& input) {
  for (const HandTrack& track : input.tracks) {
    if (findTool(scenario, track.tool) < 0)
      return Error{Fault::UnknownId, {"", "/tracks", track.tool, {}}, {track.tool, "tool"}, "recording's track"};
    if (track.keys.empty())
      return Error{Fault::Unusable, {"", "/tracks", track.tool, {}}, {"a track without keys"}, "recording's track"};
  }
  return Done{};
}

Recording recordingOf(const Model& model, const RunOptions& options, const RunReport& report) {
  Recording recording;
  if (options.input) {
    recording.tracks = options.input->tracks;
    recording.marks = options.input->marks;
  }
  recording.scenario = report.scenario;
  recording.dt = model.scenario.dt;
  recording.profile = report.profile;
  recording.seed = model.scenario.seed;
  recording.steps = report.steps;
  recording.jointHash = report.jointHash;
  recording.build = report.build;
  recording.isa = report.isa;
  recording.stateHash = report.stateHash;
  return recording;
}

}  // namespace

void handsAt(const Scenario& scenario, const Recording* input, double time, std::vector<Pose>& hands) {
  hands.resize(scenario.tools.size());
  for (std::size_t i = 0; i < hands.size(); ++i) hands[i] = scenario.tools[i].home;
  if (!input) return;
  for (const HandTrack& track : input->tracks) {
    const int tool = findTool(scenario, track.tool);
    if (tool >= 0 && !track.keys.empty()) hands[tool] = handAt(track, time);
  }
}

double inputSeconds(const Recording& input) {
  double end = 0;
  for (const HandTrack& track : input.tracks)
    if (!track.keys.empty()) end = std::max(end, track.keys.back().time);
  for (const RecordingMark& mark : input.marks) end = std::max(end, mark.end);
  return end;
}

Result<RunResult> runScenario(std::shared_ptr<const Model> model, const RunOptions& options) {
  const double dt = model->scenario.dt;
  const Result<long> steps = stepCount(options, dt);
  if (!steps) return steps.error();
  if (options.input)
    if (const Result<Done> fits = checkInput(model->scenario, *options.input); !fits) return fits.error();

  RunResult result;
  State& state = result.state = model->start;
  Stepper stepper(model, options.stepper);
  RunGather gather(*model, options.input, *steps, options.stepper.profile);
  std::optional<PenetrationProbe> collision, visual;
  if (options.checks) collision.emplace(*model, SurfaceKind::Collision);
  if (collision) collision->setLimit(options.failDepth);
  std::optional<RunWatch> watch;
  const bool stretchLaw = hasStretchLaw(options.stepper.profile, options.stepper.paper);
  if (options.checks) watch.emplace(*model, stretchLaw);
  if (options.checks && options.visualEvery > 0) visual.emplace(*model, SurfaceKind::Visual);
  std::optional<TrainingWatch> training;
  if (!model->scenario.training.tasks.empty()) {
    Result<TrainingWatch> made = TrainingWatch::make(*model, options.trainingTrace);
    if (!made) return made.error();
    training = std::move(*made);
  }
  std::optional<Pacer> pacer;
  if (options.realtime) pacer.emplace(dt);

  RunReport& report = result.report;
  std::optional<RunHaptics> haptics;
  if (options.realtime && options.haptic) {
    report.hapticReason = RunHaptics::reasonAgainst(*model, options.stepper.profile);
    if (report.hapticReason.empty()) haptics.emplace(*model, stepper, options.input, *options.haptic, static_cast<double>(*steps) * dt);
  } else if (options.realtime) {
    report.hapticReason = "not-asked";
  }
  Inputs inputs;
  const auto begun = std::chrono::steady_clock::now();
  std::optional<Notice> stopped;
  for (long s = 0; s < *steps && !stopped; ++s) {
    if (pacer) pacer->waitForStep();
    if (haptics) haptics->beginStep();
    const double time = state.time;
    // The hand's pose at the step's end is what the implicit step pulls towards.
    handsAt(model->scenario, options.input, static_cast<double>(s + 1) * dt, inputs.hands);
    if (haptics) haptics->takeHands(static_cast<double>(s + 1) * dt, inputs.hands);
    const StepReport& step = stepper.step(inputs, state);
    if (haptics) haptics->endStep(step, state, pacer->report().slowedSeconds);
    gather.add(step, time, state.v);
    if (collision) collision->look(state.q, step.dents, state.time, state.step);
    if (watch) watch->look(state);
    if (training) {
      training->add(step, state);
      if (options.observeTraining) options.observeTraining(*training, state.time);
    }
    if (visual && (s + 1) % options.visualEvery == 0) visual->look(state.q, step.dents);
    if (options.observe) options.observe(step, state, collision ? collision->lastLook() : std::span<const Penetration>());
    const std::chrono::duration<double> taken = std::chrono::steady_clock::now() - begun;
    if (options.timeLimit > 0 && taken.count() > options.timeLimit && s + 1 < *steps) stopped = timeUp(*model, step, state, options.timeLimit);
    if (stopped || s + 1 == *steps) {
      result.contacts = step.contactViews;
      result.dents = step.dents;
    }
    if (options.progress && !options.progress(static_cast<double>(s + 1) / static_cast<double>(*steps)))
      return Error{Fault::Cancelled, {}, {}, "run"};
  }

  gather.finish(report);
  report.scenario = model->scenario.id;
  report.profile = profileName(options.stepper.profile);
  report.solver = solverName(*model, options.stepper.profile);
  report.build = buildId();
  report.isa = kernelIsa(options.stepper.portable);
  report.jointHash = model->jointHash;
  report.stateHash = toHex(stateHash(state));
  report.dt = dt;
  report.seed = model->scenario.seed;
  report.threads = options.stepper.threads;
  report.realtime = options.realtime;
  report.finite = state.q.allFinite() && state.v.allFinite();
  report.tissueLaw = stretchLaw ? "stretch" : "linear";
  report.parts = partReports(*model);
  for (std::size_t i = 0; watch && i < report.parts.size(); ++i)  // parts come first among the objects, in the joint's order
    if (const auto most = watch->troubleMost(static_cast<int>(i))) {
      report.parts[i].insideOutMax = most->insideOut;
      report.parts[i].pressedMax = most->pressed;
    }
  report.couplingIslands = model->couplingIslandCount;
  if (collision) {
    report.penetrationMax = collision->deepest();
    report.penetrationPair = collision->where();
  }
  if (visual) {
    report.visualPenetrationMax = visual->deepest();
    report.visualPenetrationPair = visual->where();
    report.visualPenetrationEvery = options.visualEvery;
  }
  if (training) {
    report.training = training->report();
    if (options.trainingTrace) result.trainingTrace = training->csv();
  }
  report.notices = noticesBefore(*model, options.input, report.seconds);
  for (const Notice& notice : missedMarks(report)) report.notices.push_back(notice);
  if (watch) report.notices.insert(report.notices.end(), watch->notices().begin(), watch->notices().end());
  if (const auto bounded = gather.bounded()) report.notices.push_back(*bounded);
  if (stopped) report.notices.push_back(*stopped);
  if (collision)
    for (const Notice& deep : collision->tooDeep()) report.notices.push_back(deep);
  const auto& couplings = model->joint.couplings;
  const bool regions = couplings.empty() || !std::all_of(couplings.begin(), couplings.end(), [](const Coupling& coupling) { return coupling.byNodes(); });
  if (report.paper) report.paper->departures = paperDepartures(options.stepper.paper, regions);
  if (pacer) report.pace = pacer->report();
  if (haptics) {
    report.haptic = haptics->finish(options.compareProgress);
    for (EffectReport& effect : report.effects)
      if (effect.name == "haptics") effect = {effect.name, "on", model->scenario.effects.haptics == Wish::On ? "asked-on" : "auto-present", haptics->publishMs(), ""};
    std::erase_if(report.notices, [](const Notice& notice) { return notice.kind == NoticeKind::UnusedSetting && notice.subject == "haptics"; });
  }
  if (options.record) {
    result.recording = recordingOf(*model, options, report);
    for (HandTrack& track : haptics ? haptics->liveTracks() : std::vector<HandTrack>()) {
      std::erase_if(result.recording->tracks, [&](const HandTrack& other) { return other.tool == track.tool; });
      result.recording->tracks.push_back(std::move(track));
    }
  }
  return result;
}

}  // namespace glenoid
