// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands/Commands.h"
#include "app/commands/Console.h"
#include "app/commands/Devices.h"
#include "app/commands/OpenScene.h"
#include "app/commands/Outcome.h"
#include "app/commands/Picture.h"
#include "app/records/RunRecorder.h"
#include "editor/core/NoticeSentences.h"
#include "simcore/file/AtomicWrite.h"
#include "simcore/file/Json.h"
#include "simcore/haptic/DeviceProfile.h"
#include "simcore/live/BuildId.h"
#include "simcore/live/PenetrationProbe.h"
#include "simcore/live/Run.h"
#include "simcore/reading/Readings.h"
#include "simcore/reading/Tissue.h"
#include "simcore/reading/Trace.h"
#include "simcore/train/TrainingWatch.h"

namespace glenoid {
namespace {

struct Wishes {
  std::string scenario, profile, input, deviceProfile, effects, paper, failDepth, timeLimit, record, report, render, state, vtu, trainingTrace, trainee, records, trace, traceParts, tracePairs;
  std::vector<std::string> devices;
  double seconds = 0, dt = 0, compare = 10;
  long steps = 0;
  int threads = 1, every = 1;
  std::optional<unsigned> seed;
  bool realtime = false, portable = false;
  PictureWishes picture;
};

Result<Done> applyWishes(const Wishes& wishes, Scenario& scenario) {
  if (wishes.dt > 0) scenario.dt = wishes.dt;
  if (wishes.seed) scenario.seed = *wishes.seed;
  if (!wishes.profile.empty()) scenario.profile = *profileNamed(wishes.profile);
  if (wishes.effects.empty()) return Done{};
  if (!wishes.record.empty())
    return usageError("--record keeps no effects, so it goes with --effects only when they stand in the scenario file");
  return applyEffects(wishes.effects, scenario.effects);
}

/// A path that cannot be written is said before the run, not after its minutes.
Result<Done> checkOutputs(const Wishes& wishes) {
  std::vector<const std::string*> paths;
  for (const std::string* path : {&wishes.record, &wishes.report, &wishes.render, &wishes.state, &wishes.vtu, &wishes.trainingTrace, &wishes.trace}) {
    if (path->empty()) continue;
    for (const std::string* other : paths)
      if (*other == *path) return usageError("two outputs go to the same file, " + *path);
    paths.push_back(path);
    if (const auto good = checkWritable(*path); !good) return good;
  }
  return Done{};
}

Result<TraceWishes> traceWishes(const Wishes& wishes) {
  TraceWishes trace;
  trace.every = wishes.every;
  if (!wishes.traceParts.empty()) {
    auto parts = tracePartsIn(wishes.traceParts);
    if (!parts) return parts.error();
    trace.parts = std::move(*parts);
  }
  if (!wishes.tracePairs.empty()) {
    auto pairs = tracePairsIn(wishes.tracePairs);
    if (!pairs) return pairs.error();
    trace.pairs = std::move(*pairs);
  }
  return trace;
}

/// What was asked to be read off the end of the run.
Result<Done> saveReadings(const Wishes& wishes, const Model& model, const RunResult& result, const std::optional<Trace>& trace,
                          bool stretchLaw) {
  if (!wishes.state.empty()) {
    SceneReading reading = readScene(model, result.state, result.contacts);
    addPeaks(model, result.state, result.contacts, stretchLaw, reading);
    const JsonValue state = toJson(reading, wishes.scenario);
    if (const auto saved = writeJson(wishes.state, state); !saved) return saved;
  }
  if (!wishes.vtu.empty()) {
    const Result<std::string> tissue = tissueVtu(model, result.state, stretchLaw);
    if (!tissue) return tissue.error();
    if (const auto saved = writeWholeFile(wishes.vtu, *tissue); !saved) return saved;
  }
  if (!wishes.trainingTrace.empty())
    if (const auto saved = writeWholeFile(wishes.trainingTrace, result.trainingTrace); !saved) return saved;
  return trace ? writeWholeFile(wishes.trace, trace->csv()) : Done{};
}

/// A profile's id, and whose hands take part.
struct FeltWith {
  std::string profile;
  std::vector<DeviceWish> devices;
};

Result<FeltWith> feltWith(const Wishes& wishes) {
  FeltWith with{wishes.deviceProfile, {}};
  for (const std::string& word : wishes.devices) {
    const DeviceWish wish = deviceWish(word);
    if (namesDevice(wish.address)) {
      with.devices.push_back(wish);
    } else if (!with.profile.empty()) {
      return usageError("“" + word + "” and “" + with.profile + "” are two profiles, and forces are made for one");
    } else {
      with.profile = word;
    }
  }
  if (with.profile.empty() && with.devices.empty()) with.profile = kReferenceDevice;
  if (!with.profile.empty()) return with;
  const Result<DeviceAddress> address = deviceAddress(with.devices.front().address);
  if (!address) return address.error();
  with.profile = profileOf(address->kind);
  return with;
}

Result<Done> run(const Wishes& wishes) {
  if (const auto good = checkColours(wishes.picture); !good) return good;
  if (!wishes.picture.colour.empty() && wishes.render.empty()) return usageError("--colour is for the picture that --render writes, and goes with it only");
  if (const auto good = checkOutputs(wishes); !good) return good;
  RunOptions options;
  if (!wishes.timeLimit.empty()) {
    const Result<double> limit = durationNamed("--time-limit", wishes.timeLimit);
    if (!limit) return limit.error();
    options.timeLimit = *limit;
  }
  Result<OpenScene> scene = openScenario(wishes.scenario);
  if (!scene) return scene.error();
  if (const auto set = applyWishes(wishes, scene->scenario); !set) return set.error();
  const Result<std::optional<Recording>> input = openInput(wishes.input, wishes.scenario, scene->scenario);
  if (!input) return input.error();
  const auto model = compileModel(scene->joint, scene->scenario);
  if (!model) return model.error();
  std::optional<Trace> trace;
  if (!wishes.trace.empty()) {
    const Result<TraceWishes> asked = traceWishes(wishes);
    if (!asked) return asked.error();
    Result<Trace> made = Trace::make(**model, *asked);
    if (!made) return made.error();
    trace = std::move(*made);
    PenetrationProbe probe(**model, SurfaceKind::Collision);
    probe.look((*model)->start.q);
    trace->begin((*model)->start, probe.lastLook());
  }
  if (!wishes.vtu.empty())
    if (const auto tissue = tissueVtu(**model, (*model)->start); !tissue) return tissue.error();

  options.steps = wishes.steps;
  options.seconds = wishes.seconds;
  if (options.steps == 0 && options.seconds == 0) options.seconds = *input ? inputSeconds(**input) : 0;
  if (options.steps == 0 && options.seconds == 0) options.seconds = 10;
  options.stepper = {scene->scenario.profile, wishes.threads, wishes.portable};
  if (const auto set = applyPaper(wishes.paper, options.stepper.paper); !set) return set.error();
  if (!wishes.paper.empty() && scene->scenario.profile != Profile::Paper) return usageError("--paper goes with the profile “paper” only");
  if (!wishes.paper.empty() && !wishes.record.empty()) return usageError("--record keeps no additions to the published step, so it goes without --paper");
  if (!wishes.failDepth.empty()) {
    const Result<double> depth = lengthNamed("--fail-depth", wishes.failDepth);
    if (!depth) return depth.error();
    options.failDepth = *depth;
  }
  options.input = *input ? &**input : nullptr;
  options.record = !wishes.record.empty();
  options.trainingTrace = !wishes.trainingTrace.empty();
  if (!wishes.records.empty() && wishes.trainee.empty()) return usageError("--records is where a run is kept for somebody, and goes with --trainee NAME");
  if (!wishes.trainee.empty() && scene->scenario.training.tasks.empty())
    return usageError("--trainee keeps how a training went, and the scenario “" + wishes.scenario + "” has no tasks");
  if (options.trainingTrace && scene->scenario.training.tasks.empty())
    return usageError("--training-trace is of tasks, and the scenario “" + wishes.scenario + "” has none");
  options.realtime = wishes.realtime;
  if (!(wishes.devices.empty() && wishes.deviceProfile.empty()) && !wishes.realtime)
    return usageError("--device is what a run in real time is felt with, and goes with --realtime");
  HeldTools held;  // outlives the run
  if (wishes.realtime) {
    const Result<FeltWith> with = feltWith(wishes);
    if (!with) return with.error();
    Result<DeviceProfile> device = deviceNamed(with->profile);
    if (!device) return device.error();
    Result<HeldTools> tools = holdTools(with->devices, scene->scenario);
    if (!tools) return tools.error();
    held = std::move(*tools);
    options.haptic = {std::move(*device), wishes.compare, held.hands};
  }
  if (trace) options.observe = [&trace](const StepReport& step, const State& state, std::span<const Penetration> depths) { trace->add(step, state, depths); };
  ProgressLine progress("Running " + wishes.scenario);
  options.progress = [&](double fraction) {
    progress.show(fraction);
    return true;
  };
  std::optional<ProgressLine> comparing;
  options.compareProgress = [&](double fraction) {
    if (!comparing) comparing.emplace("Comparing with the exact step");
    comparing->show(fraction);
    return true;
  };
  std::unique_ptr<RunRecorder> recorder;
  if (!wishes.trainee.empty()) {
    auto begun = RunRecorder::begin({wishes.records, wishes.trainee, wishes.scenario, buildId(), (*model)->jointHash});
    if (!begun) return begun.error();
    recorder = std::move(*begun);
    options.observeTraining = [&recorder](const TrainingWatch& training, double time) {
      if (recorder->isDue()) recorder->tell(time, training.tasksSoFar());
    };
  }
  Result<RunResult> result = runScenario(*model, options);
  comparing.reset();
  if (!result) return result.error();
  result->report.scenario = wishes.scenario;
  const bool stretchLaw = hasStretchLaw(scene->scenario.profile, options.stepper.paper);
  if (result->recording) result->recording->scenario = wishes.scenario;

  // Whatever becomes of the records, what was asked for as files is written first.
  const Result<Done> kept = recorder ? recorder->finish(result->report) : Result<Done>(Done{});
  if (result->recording)
    if (const auto saved = saveOutcome(*result->recording, wishes.record); !saved) return saved.error();
  if (!wishes.report.empty())
    if (const auto saved = saveOutcome(result->report, **model, wishes.report); !saved) return saved.error();
  if (const auto saved = saveReadings(wishes, **model, *result, trace, stretchLaw); !saved) return saved;
  if (!wishes.render.empty()) {
    PictureWishes picture = wishes.picture;
    picture.out = wishes.render;
    picture.stretchLaw = stretchLaw;
    if (const auto drawn = drawPicture(**model, result->state, result->contacts, picture, result->dents); !drawn) return drawn.error();
  }
  std::fputs(summaryOf(result->report, **model).c_str(), stdout);
  if (!kept) return kept;
  for (const Notice& notice : result->report.notices)
    if (notice.kind == NoticeKind::TooDeep || notice.kind == NoticeKind::TimeUp) {
      QString sentence = sentenceOf(notice);
      sentence.chop(1);  // the error's own sentence ends it
      return Error{Fault::CheckFailed, {}, {sentence.toStdString()}, "run --fail-depth or --time-limit"};
    }
  return Done{};
}

}  // namespace

void addRunCommand(CLI::App& app, int& status) {
  auto wishes = std::make_shared<Wishes>();
  CLI::App* command = app.add_subcommand("run", "Run a scenario without a window and report what happened");
  command->add_option("SCENARIO", wishes->scenario, "A .scenario.json file, builtin:arthroscopy, builtin:palpation, or with tasks builtin:tour or builtin:landmarks")
      ->required();
  auto* seconds = command->add_option("--seconds", wishes->seconds,
                                      "Simulated time, s; without it the length of the input, or 10")
                      ->check(CLI::PositiveNumber);
  command->add_option("--steps", wishes->steps, "The same in steps")->check(CLI::Range(1L, kRunStepsMax))->excludes(seconds);
  command->add_option("--dt", wishes->dt, "Time step, s, at most 0.1")->check(CLI::Range(1e-6, 0.1));
  command->add_option("--profile", wishes->profile, "How a step is solved: paper, direct or reference")
      ->check(CLI::IsMember({"paper", "direct", "reference"}));
  command->add_option("--input", wishes->input, "Hands over time: a .recording; without it the scenario's own");
  command->add_flag("--realtime", wishes->realtime, "Keep pace with the clock");
  command->add_option("--device", wishes->devices,
                      "With --realtime: a device that holds a tool, haply, spnav, bridge or igtl, with an address as haply:HOST:PORT (“glenoid devices” lists "
                      "them), or TOOL=DEVICE, once for each hand; or else the profile that forces on recorded hands are made for")
      ->allow_extra_args(false);
  command->add_option("--device-profile", wishes->deviceProfile,
                      "With --realtime: whose profile forces are made for, an id of resources/devices/devices.json or ID@FILE; without it the device's own");
  command->add_option("--haptic-compare", wishes->compare,
                      "With --realtime: how many seconds from the start are compared with the exact step at the haptic rate afterwards; 0: none")
      ->check(CLI::Range(0.0, 600.0));
  command->add_option("--effects", wishes->effects, "Such as friction=off,damping=on");
  command->add_option("--paper", wishes->paper,
                      "What the paper profile adds to the published step: tension, recovery-cap, parts, search-again, stretch-law, such as parts=on");
  command->add_option("--fail-depth", wishes->failDepth,
                      "Exit status 1 where two objects lie deeper in each other, such as 0.5mm; none: never; without it a third of "
                      "the thickness of the thinner one");
  command->add_option("--time-limit", wishes->timeLimit,
                      "Stop with status 1 where the run takes longer by the clock, such as 600s or 10min, with the report up to there");
  command->add_option("--threads", wishes->threads, "Threads of the step; the result is the same")->check(CLI::Range(1, 64));
  command->add_option("--record", wishes->record, "Write a .recording that “glenoid replay --check” can repeat");
  command->add_option("--report", wishes->report, "Write the report as JSON");
  command->add_option("--render", wishes->render, "Write a picture of the end as PNG");
  addColourOptions(*command, wishes->picture);
  command->add_option("--state", wishes->state,
                      "Write where parts are and what acts on them at the end as JSON (schemas/run-state.schema.json)");
  auto* trace = command->add_option("--trace", wishes->trace,
                                    "Write a table (CSV) of how parts move, press on each other and lie in each other, a row at the start and every N steps");
  command->add_option("--every", wishes->every, "Steps between two rows of the trace")->check(CLI::Range(1, 1000000000))->needs(trace);
  command->add_option("--trace-parts", wishes->traceParts, "Parts or tools of the trace, as ID,ID,…; without it all that move")
      ->needs(trace);
  command->add_option("--trace-pairs", wishes->tracePairs,
                      "Pairs whose contact force (on the first of each) and depth the trace holds, as ID:ID,…; without it all that touch")
      ->needs(trace);
  command->add_option("--trainee", wishes->trainee, "Keep the run in the records for this person");
  command->add_option("--records", wishes->records, "With --trainee: a file, or postgresql://USER@HOST/DATABASE; without it the user's own file");
  command->add_option("--training-trace", wishes->trainingTrace,
                      "Write what the metrics of a training are made of as a table (CSV): tips, forces and tasks at every step");
  command->add_option("--vtu", wishes->vtu,
                      "Write displacement, strain, stress and von Mises stress of the soft parts at the end as VTK unstructured grid");
  command->add_option("--seed", wishes->seed, "Kept with recordings; nothing in this version is drawn at random");
  command->add_flag("--portable", wishes->portable, "Use no SIMD kernels: same bits on every processor");
  command->callback([wishes, &status] {
    const Result<Done> done = run(*wishes);
    status = done ? kDone : complain(done.error());
  });
}

}  // namespace glenoid
