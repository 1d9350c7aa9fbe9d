// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/StabilityStudy.h"

#include <algorithm>
#include <atomic>
#include <thread>

#include "simcore/scene/SceneWords.h"

namespace glenoid {
namespace {

struct Job {
  StabilityStage* stage;
  StabilityTrial trial;
  bool counts;
  double timeLimit;
};

Result<StabilityVerdict> runJob(const Job& job) {
  Result<StabilityRun> run = job.stage->runOf(job.trial);
  if (!run) return run.error();
  run->timeLimit = job.timeLimit;
  StabilityVerdict verdict;
  verdict.trial = job.trial;
  verdict.profile = job.stage->profile();
  verdict.counts = job.counts;
  verdict.carried = job.stage->carried(job.trial);
  verdict.figures = measureStability(*run);
  verdict.broken = brokenBounds(*run, verdict.figures, verdict.carried.share <= 1);
  verdict.model = run->model;
  return verdict;
}

/// All jobs, by as many threads as are wished.
Result<std::vector<StabilityVerdict>> runJobs(const std::vector<Job>& jobs, const StabilityOptions& options) {
  std::vector<std::optional<StabilityVerdict>> found(jobs.size());
  std::optional<Error> failed;
  std::mutex mutex;
  std::atomic<std::size_t> next{0};
  std::size_t done = 0;
  const auto work = [&] {
    for (std::size_t i = next++; i < jobs.size(); i = next++) {
      Result<StabilityVerdict> verdict = runJob(jobs[i]);
      const std::lock_guard lock(mutex);
      if (failed) return;
      if (!verdict) failed = verdict.error();
      else {
        if (options.told) options.told(*verdict);
        found[i] = std::move(*verdict);
      }
      ++done;
      if (options.progress && !options.progress(static_cast<double>(done) / static_cast<double>(jobs.size()))) failed = Error{Fault::Cancelled, {}, {}, "stability"};
    }
  };
  std::vector<std::thread> threads;
  for (int i = 1; i < options.threads; ++i) threads.emplace_back(work);
  work();
  for (std::thread& thread : threads) thread.join();
  if (failed) return *failed;
  std::vector<StabilityVerdict> verdicts;
  for (auto& verdict : found) verdicts.push_back(std::move(*verdict));
  return verdicts;
}

std::string listOf(const std::vector<std::string>& words) {
  std::string list;
  for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
  return list;
}

}  // namespace

Result<std::vector<StabilityVerdict>> runStability(const StabilityScene& scene, const StabilityOptions& options) {
  for (const std::string& id : options.only)
    if (!findStabilityCase(id)) return Error{Fault::UnknownId, {}, {id, "case of the gauntlet"}, "stability"};
  const auto chosen = [&](const StabilityTrial& trial) {
    return options.only.empty() || std::find(options.only.begin(), options.only.end(), trial.what->id) != options.only.end();
  };
  auto stage = StabilityStage::make(scene, options.profile);
  if (!stage) return stage.error();
  std::vector<Job> jobs;
  for (const StabilityTrial& trial : (*stage)->trials(options.quick))
    if (chosen(trial)) jobs.push_back({stage->get(), trial, true, options.trialLimit});
  std::unique_ptr<StabilityStage> paper;
  if (options.paper && options.profile != Profile::Paper) {
    auto made = StabilityStage::make(scene, Profile::Paper);
    if (!made) return made.error();
    paper = std::move(*made);
    for (const StabilityTrial& trial : paper->trials(true))
      if (chosen(trial)) jobs.push_back({paper.get(), trial, false, options.paperLimit});
  }
  return runJobs(jobs, options);
}

StudyTable stabilityTable(std::span<const StabilityVerdict> verdicts, const StabilityOptions& options) {
  StudyTable table;
  table.id = "stability";
  long counted = 0, held = 0, beside = 0, besideHeld = 0;
  for (const StabilityVerdict& verdict : verdicts) {
    (verdict.counts ? counted : beside) += 1;
    (verdict.counts ? held : besideHeld) += verdict.held();
  }
  table.facts = {{"profile", std::string(scene_words::wordOf(scene_words::kProfiles, options.profile))},
                 {"trials", counted},
                 {"held", held},
                 {"boundEnergyExcess", kGauntletBounds.energyExcess},
                 {"boundDepthMm", 1e3 * kGauntletBounds.depth},
                 {"boundDepthOfThickness", kGauntletBounds.thinShare},
                 {"boundSecondsToRestS", kGauntletBounds.secondsToRest},
                 {"boundRestSpeedMPerS", kGauntletBounds.restSpeed}};
  if (beside > 0) table.facts.insert(table.facts.end(), {{"paperTrials", beside}, {"paperHeld", besideHeld}});
  table.columns = {"trial", "case", "subject", "profile", "stepMs", "counts", "verdict", "finite", "rejectedSteps", "energyExcess", "energyGainedJ",
                   "depthMm", "depthOfBound", "depthPair", "depthEndMm", "recoveryS", "endSpeedMPerS", "insideOutMost", "insideOutEnd", "movedMm",
                   "contactsMost", "partsMost", "unsettled", "steps", "carriedShare", "hash"};
  for (const StabilityVerdict& verdict : verdicts) {
    const StabilityFigures& f = verdict.figures;
    std::string word = verdict.held() ? "held" : listOf(verdict.broken);
    if (verdict.held() && verdict.carried.share > 1) word = "held, cannot carry itself";
    table.rows.push_back({verdict.trial.id(), std::string(verdict.trial.what->id), verdict.trial.subject,
                          std::string(scene_words::wordOf(scene_words::kProfiles, verdict.profile)), 1e3 * verdict.trial.dt, verdict.counts, word, f.finite,
                          f.rejected, f.energyExcess, f.energyGained, 1e3 * f.depth, f.depthShare, f.depthPair, 1e3 * f.depthEnd, f.secondsToRest,
                          f.restSpeed, static_cast<long>(f.insideOut), static_cast<long>(f.insideOutEnd), 1e3 * f.moved, static_cast<long>(f.contactsMax),
                          static_cast<long>(f.partsMost), f.pivotsExhausted, f.steps, verdict.carried.share, toHex(stateHash(f.end))});
  }
  return table;
}

}  // namespace glenoid
