// SPDX-License-Identifier: GPL-3.0-or-later
#include <CLI/CLI.hpp>
#include <algorithm>
#include <cstdio>
#include <memory>

#include "app/commands/Console.h"
#include "app/commands/StudyCommand.h"
#include "app/commands/StudyFiles.h"
#include "app/commands/StudyTruthFiles.h"
#include "simcore/live/RunReport.h"
#include "simcore/study/ThreadsGranted.h"

namespace glenoid {
namespace {

struct TruthWishes {
  std::string out, profile = "direct", elements;
  std::vector<std::string> only;
  bool quick = false, list = false;
  int threads = 0;
};

Result<Done> studyTruth(const TruthWishes& wishes) {
  if (wishes.list) {
    for (const truth::TruthProblem& problem : truth::truthProblems())
      std::printf("%-22s %s (%s)\n", problem.id, problem.title, problem.source);
    return Done{};
  }
  if (wishes.out.empty()) return usageError("--out wants a folder for tables, plots and scenes");
  truth::TruthOptions options;
  options.quick = wishes.quick;
  options.profile = *profileNamed(wishes.profile);
  options.only = wishes.only;
  if (!wishes.elements.empty())
    options.elements = wishes.elements == "cells" ? Elements::Cells : Elements::Tetrahedra;
  options.threads = wishes.threads > 0
                        ? wishes.threads
                        : std::min(threadsGranted(), 16);
  if (const auto good = prepareFolder(wishes.out); !good) return good;
  Result<std::vector<truth::TruthVerdict>> verdicts = std::vector<truth::TruthVerdict>{};
  {
    ProgressLine progress("Solving problems with known answers");
    options.progress = [&](double fraction) {
      progress.show(fraction);
      return true;
    };
    verdicts = truth::runTruth(options);
  }
  if (!verdicts) return verdicts.error();
  const std::vector<TruthOther> others = truthByCalculix(*verdicts, wishes.out);
  if (const auto saved = writeTruth(wishes.out, *verdicts, others, options); !saved) return saved;
  if (const auto saved = writeTruthScenes(wishes.out, *verdicts, options); !saved) return saved;
  std::fputs(truthSummaryText(*verdicts, others).c_str(), stdout);
  std::printf("Tables, plots and scenes are in %s.\n", wishes.out.c_str());
  std::string missed;
  for (const truth::TruthVerdict& verdict : *verdicts) {
    if (verdict.met()) continue;
    missed +=
        (missed.empty() ? "" : ", ") + std::string(verdict.problem->id) +
        (verdict.problem->byElements ? std::string(" (") + truth::elementsWord(verdict.elements) + ")" : "");
  }
  if (missed.empty()) return Done{};
  return Error{Fault::CheckFailed, {}, {"these answers are not within their bars: " + missed}, "study truth"};
}

}  // namespace

void addTruthStudy(CLI::App& study, int& status) {
  auto wishes = std::make_shared<TruthWishes>();
  CLI::App* command = study.add_subcommand(
      "truth", "Problems with known answers, solved by the same elements, contact and steps as every scene");
  command->add_option("--out", wishes->out,
                      "Folder for tables (CSV, JSON), a plot for each problem (PNG, SVG, PDF), summary.txt "
                      "and scenes; made where it is not there");
  command->add_option("--only", wishes->only, "Only these, such as cook,hertz")->delimiter(',');
  command->add_option("--profile", wishes->profile, "Profile of whole steps; without it direct")
      ->check(CLI::IsMember({"paper", "direct", "reference"}));
  command->add_option("--elements", wishes->elements, "Only tetrahedra or cells; without it both")
      ->check(CLI::IsMember({"tetrahedra", "cells"}));
  command->add_option("--threads", wishes->threads, "Solves at a time; the figures are the same")
      ->check(CLI::Range(1, 64));
  command->add_flag("--quick", wishes->quick, "Coarser finest sizes, with bars of their own");
  command->add_flag("--list", wishes->list, "Say which problems there are, and solve none");
  command->callback([wishes, &status] {
    const Result<Done> done = studyTruth(*wishes);
    status = done ? kDone : complain(done.error());
  });
}

}  // namespace glenoid
