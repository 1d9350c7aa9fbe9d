// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>

#include "app/commands/Commands.h"
#include "app/commands/Console.h"
#include "app/commands/OpenScene.h"
#include "app/commands/Outcome.h"
#include "app/commands/StabilityFiles.h"
#include "simcore/live/BuildId.h"
#include "simcore/live/Run.h"

namespace glenoid {
namespace {

struct Wishes {
  std::string recording, report;
  bool check = false;
};

/// Why the recording cannot be expected to give the same bits here; empty when it can.
std::string difference(const Recording& recording, const RunReport& report) {
  if (recording.jointHash != report.jointHash) return "the joint is not the one that was recorded";
  if (recording.isa != report.isa)
    return "it was recorded with the instruction set " + recording.isa + ", and this run used " + report.isa;
  if (recording.build != report.build)
    return "it was recorded by build " + recording.build + ", and this is " + report.build;
  return {};
}

Result<Done> checkAgainst(const Recording& recording, const RunReport& report) {
  if (recording.stateHash == report.stateHash) return Done{};
  std::string what = "the run ended in state " + report.stateHash + " instead of " + recording.stateHash;
  const std::string reason = difference(recording, report);
  what += reason.empty() ? ", with the same joint, build and instruction set" : "; " + reason;
  return Error{Fault::CheckFailed, {}, {what}, "replay"};
}

/// A trial of `study stability`: what is done to the scene is said by its name.
Result<Done> replayGauntlet(const Recording& recording, const Wishes& wishes) {
  if (!wishes.report.empty()) return usageError("a recording of the gauntlet has figures of its own and gives no run report, so it goes without --report");
  const Result<StabilityVerdict> verdict = repeatStability(recording);
  if (!verdict) return verdict.error();
  const std::string why = stabilitySentences(*verdict);
  std::printf("%s: %s\n", verdict->trial.id().c_str(), why.empty() ? "It held." : why.c_str());
  if (!wishes.check) return Done{};
  RunReport report;
  report.stateHash = toHex(stateHash(verdict->figures.end));
  report.jointHash = verdict->model->jointHash;
  report.isa = kernelIsa(false);
  report.build = buildId();
  if (const auto same = checkAgainst(recording, report); !same) return same.error();
  std::puts("The state at the end is the recorded one, bit by bit.");
  return Done{};
}

Result<Done> replay(const Wishes& wishes) {
  const Result<Recording> recording = openRecording(wishes.recording);
  if (!recording) return recording.error();
  const Place place{wishes.recording, "", "", {}};
  if (wishes.check && recording->stateHash.empty())
    return Error{Fault::Unusable, place, {"the recording is an input and holds no expected state"}, "replay --check"};
  if (stabilityTrialIn(*recording)) return replayGauntlet(*recording, wishes);
  Result<OpenScene> scene = openScenario(recording->scenario);
  if (!scene) return scene.error();
  scene->scenario.dt = recording->dt;
  scene->scenario.seed = recording->seed;
  const auto profile = profileNamed(recording->profile);
  if (!profile) return Error{Fault::UnknownId, place, {recording->profile, "profile"}, "replay"};
  scene->scenario.profile = *profile;
  const auto model = compileModel(scene->joint, scene->scenario);
  if (!model) return model.error();

  RunOptions options;
  options.steps = recording->steps;
  if (options.steps == 0) options.seconds = std::max(inputSeconds(*recording), recording->dt);
  options.stepper = {*profile, 1, recording->isa == kernelIsa(true)};
  options.input = &*recording;
  ProgressLine progress("Replaying " + wishes.recording);
  options.progress = [&](double fraction) {
    progress.show(fraction);
    return true;
  };
  Result<RunResult> result = runScenario(*model, options);
  if (!result) return result.error();
  result->report.scenario = recording->scenario;
  if (!wishes.report.empty())
    if (const auto saved = saveOutcome(result->report, **model, wishes.report); !saved) return saved.error();
  std::fputs(summaryOf(result->report, **model).c_str(), stdout);
  if (!wishes.check) return Done{};
  if (const auto same = checkAgainst(*recording, result->report); !same) return same.error();
  std::puts("The state at the end is the recorded one, bit by bit.");
  return Done{};
}

}  // namespace

void addReplayCommand(CLI::App& app, int& status) {
  auto wishes = std::make_shared<Wishes>();
  CLI::App* command = app.add_subcommand("replay", "Repeat a recorded run");
  command->add_option("RECORDING", wishes->recording, "A .recording file")->required();
  command->add_flag("--check", wishes->check, "Compare the state at the end with the recorded one; exit status 1 if it differs");
  command->add_option("--report", wishes->report, "Write the report as JSON");
  command->callback([wishes, &status] {
    const Result<Done> done = replay(*wishes);
    status = done ? kDone : complain(done.error());
  });
}

}  // namespace glenoid
