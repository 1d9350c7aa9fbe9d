// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>

#include "app/commands/Console.h"
#include "app/commands/StabilityFiles.h"
#include "app/commands/StudyCommand.h"
#include "app/commands/StudyFiles.h"
#include "app/commands/StudyNews.h"
#include "app/commands/TableText.h"
#include "simcore/file/AtomicWrite.h"
#include "simcore/live/Run.h"
#include "simcore/study/ThreadsGranted.h"

namespace glenoid {
namespace {

struct Wishes {
  std::string scene, out, profile;
  std::vector<std::string> cases;
  bool quick = false, noPaper = false;
  int threads = 0;
};

/// The gauntlet itself and its files.
Result<Done> runGauntlet(const Wishes& wishes, const StabilityScene& scene, StudyNews& news) {
  StabilityOptions options;
  options.profile = wishes.profile.empty() ? scene.scenario.profile : *profileNamed(wishes.profile);
  options.quick = wishes.quick;
  options.paper = !wishes.noPaper && options.profile != Profile::Paper;
  options.trialLimit = wishes.quick ? 40 : 120;
  options.paperLimit = wishes.quick ? 4 : 10;
  options.threads = wishes.threads > 0 ? wishes.threads : std::min(threadsGranted(), 16);
  options.only = wishes.cases;
  Result<std::vector<StabilityVerdict>> verdicts = std::vector<StabilityVerdict>{};
  {
    ProgressLine progress("Running the gauntlet");
    Result<Done> written = Done{};  // of failures, each as soon as it is known
    options.progress = [&](double fraction) {
      progress.show(fraction);
      news.progress("", fraction);
      return true;
    };
    options.told = [&](const StabilityVerdict& verdict) {
      if (!verdict.held() && written) written = writeFailure(wishes.out, verdict, wishes.scene);
      news.row(stabilityTable({&verdict, 1}, options), 0);
    };
    verdicts = runStability(scene, options);
    if (!written) return written;
  }
  if (!verdicts) return verdicts.error();
  if (const auto written = writeStability(wishes.out, *verdicts, options, wishes.scene); !written) return written;
  news.documentIsThere();
  StudyTable summary = stabilitySummary(*verdicts);
  summary.facts = stabilityTable(*verdicts, options).facts;
  std::fputs(tableText(summary, "The gauntlet: worst figures of each case").c_str(), stdout);
  long broken = 0, counted = 0;
  std::string first;
  for (const StabilityVerdict& verdict : *verdicts) {
    if (!verdict.counts) continue;
    ++counted;
    if (verdict.held()) continue;
    if (broken++ == 0) first = verdict.trial.id();
    std::printf("%s: %s\n", verdict.trial.id().c_str(), stabilitySentences(verdict).c_str());
  }
  std::printf("Tables, pictures and recordings are in %s.\n", wishes.out.c_str());
  if (broken == 0) return Done{};
  return Error{Fault::CheckFailed, {}, {text("%ld of %ld trials of the gauntlet did not hold, the first of them %s", broken, counted, first.c_str())}, "study stability"};
}

Result<Done> stability(const Wishes& wishes) {
  const Result<StabilityScene> scene = openStabilityScene(wishes.scene);
  if (!scene) return scene.error();
  std::error_code failed;
  std::filesystem::create_directories(wishes.out, failed);
  if (const auto good = checkWritable(wishes.out + "/stability.json"); !good) return good;
  JsonValue what = machineJson();
  what.set("study", "stability");
  what.set("scenario", wishes.scene);
  what.set("quick", wishes.quick);
  StudyNews news(wishes.out, std::move(what));
  const Result<Done> done = runGauntlet(wishes, *scene, news);
  news.end(done);
  return done;
}

}  // namespace

void addStabilityStudy(CLI::App& study, int& status) {
  auto wishes = std::make_shared<Wishes>();
  CLI::App* command = study.add_subcommand("stability", "What stays stable: hard cases, one after another, with a verdict for each");
  command->add_option("SCENARIO|JOINT", wishes->scene, "A .scenario.json file, a .joint folder or builtin:NAME")->required();
  command->add_option("--out", wishes->out, "Folder for tables, and for a picture and a recording of each failure")->required();
  command->add_flag("--quick", wishes->quick, "The scene's own time step only, and one trial where the full form has several");
  command->add_option("--profile", wishes->profile, "The profile that counts; without it the scenario's")->check(CLI::IsMember({"paper", "direct", "reference"}));
  command->add_option("--cases", wishes->cases, "Only these, such as press,scattered")->delimiter(',');
  command->add_flag("--no-paper", wishes->noPaper, "Do not show the profile paper beside it");
  command->add_option("--threads", wishes->threads, "Trials at a time; the figures are the same")->check(CLI::Range(1, 64));
  command->callback([wishes, &status] {
    const Result<Done> done = stability(*wishes);
    status = done ? kDone : complain(done.error());
  });
}

}  // namespace glenoid
