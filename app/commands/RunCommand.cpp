// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <cstdio>
#include <memory>

#include "app/commands/Commands.h"
#include "app/commands/Console.h"
#include "app/commands/OpenScene.h"
#include "app/commands/Outcome.h"
#include "app/commands/Picture.h"
#include "editor/core/NoticeSentences.h"
#include "simcore/live/Run.h"

namespace glenoid {
namespace {

struct Wishes {
  std::string scenario, profile, input, effects, paper, failDepth, record, report, render;
  double seconds = 0, dt = 0;
  long steps = 0;
  int threads = 1;
  std::optional<unsigned> seed;
  bool realtime = false, portable = false;
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

Result<std::optional<Recording>> inputOf(const Wishes& wishes, const Scenario& scenario) {
  if (wishes.input.empty()) return openShippedInput(wishes.scenario, scenario);
  Result<Recording> recording = openRecording(wishes.input);
  if (!recording) return recording.error();
  return std::optional<Recording>(std::move(*recording));
}

Result<Done> run(const Wishes& wishes) {
  Result<OpenScene> scene = openScenario(wishes.scenario);
  if (!scene) return scene.error();
  if (const auto set = applyWishes(wishes, scene->scenario); !set) return set.error();
  const Result<std::optional<Recording>> input = inputOf(wishes, scene->scenario);
  if (!input) return input.error();
  const auto model = compileModel(scene->joint, scene->scenario);
  if (!model) return model.error();

  RunOptions options;
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
  options.realtime = wishes.realtime;
  ProgressLine progress("Running " + wishes.scenario);
  options.progress = [&](double fraction) {
    progress.show(fraction);
    return true;
  };
  Result<RunResult> result = runScenario(*model, options);
  if (!result) return result.error();
  result->report.scenario = wishes.scenario;
  if (result->recording) result->recording->scenario = wishes.scenario;

  if (result->recording)
    if (const auto saved = saveOutcome(*result->recording, wishes.record); !saved) return saved.error();
  if (!wishes.report.empty())
    if (const auto saved = saveOutcome(result->report, wishes.report); !saved) return saved.error();
  if (!wishes.render.empty()) {
    PictureWishes picture;
    picture.out = wishes.render;
    if (const auto drawn = drawPicture(**model, result->state, result->contacts, picture, result->dents); !drawn) return drawn.error();
  }
  std::fputs(summaryOf(result->report).c_str(), stdout);
  for (const Notice& notice : result->report.notices)
    if (notice.kind == NoticeKind::TooDeep) {
      QString sentence = sentenceOf(notice);
      sentence.chop(1);  // the error's own sentence ends it
      return Error{Fault::CheckFailed, {}, {sentence.toStdString()}, "run --fail-depth"};
    }
  return Done{};
}

}  // namespace

void addRunCommand(CLI::App& app, int& status) {
  auto wishes = std::make_shared<Wishes>();
  CLI::App* command = app.add_subcommand("run", "Run a scenario without a window and report what happened");
  command->add_option("SCENARIO", wishes->scenario, "A .scenario.json file, builtin:arthroscopy or builtin:palpation")
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
  command->add_option("--effects", wishes->effects, "Such as friction=off,damping=on");
  command->add_option("--paper", wishes->paper,
                      "What the paper profile adds to the published step: tension, recovery-cap, parts, search-again, such as parts=on");
  command->add_option("--fail-depth", wishes->failDepth,
                      "Exit status 1 where two objects lie deeper in each other, such as 0.5mm; none: never; without it a third of "
                      "the thickness of the thinner one");
  command->add_option("--threads", wishes->threads, "Threads of the step; the result is the same")->check(CLI::Range(1, 64));
  command->add_option("--record", wishes->record, "Write a .recording that “glenoid replay --check” can repeat");
  command->add_option("--report", wishes->report, "Write the report as JSON");
  command->add_option("--render", wishes->render, "Write a picture of the end as PNG");
  command->add_option("--seed", wishes->seed, "Kept with recordings; nothing in this version is drawn at random");
  command->add_flag("--portable", wishes->portable, "Use no SIMD kernels: same bits on every processor");
  command->callback([wishes, &status] {
    const Result<Done> done = run(*wishes);
    status = done ? kDone : complain(done.error());
  });
}

}  // namespace glenoid
