// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "simcore/study/StabilityTrials.h"
#include "simcore/study/StudyTable.h"

namespace glenoid {

struct StabilityVerdict;

/// How the gauntlet is run.
struct StabilityOptions {
  Profile profile = Profile::Direct;  ///< the one that counts
  bool paper = false;                 ///< show `paper` beside it, in the scene's own Δt; it does not count
  bool quick = false;
  int threads = 2;
  double trialLimit = 120;            ///< s of CPU time for a trial that counts; longer, it did not hold
  double paperLimit = 10;             ///< likewise of `paper`
  std::vector<std::string> only;      ///< ids of cases; empty: all
  std::function<bool(double)> progress;  ///< 0…1, by one thread at a time; false cancels
  std::function<void(const StabilityVerdict&)> told = {};  ///< of each trial as it ends, by one thread at a time
};

/// What came of one trial.
struct StabilityVerdict {
  StabilityTrial trial;
  Profile profile = Profile::Direct;
  bool counts = true;
  StabilityFigures figures;
  std::vector<std::string> broken;    ///< as brokenBounds; empty: it held
  CarriedShare carried;               ///< share above 1: its matter cannot carry itself
  std::shared_ptr<const Model> model;
  bool held() const { return broken.empty(); }
};

/// Runs every trial, those of `profile` first; in the order of the table whatever threads did. Figures are the same for any
/// number of threads, but for trials that ran into a time limit. Fails as compiling does, with Cancelled, or with UnknownId for a case.
Result<std::vector<StabilityVerdict>> runStability(const StabilityScene& scene, const StabilityOptions& options);

/// One line for each verdict, mm, s, m/s and J; facts: how many of those that count held, and the bounds.
StudyTable stabilityTable(std::span<const StabilityVerdict> verdicts, const StabilityOptions& options);

}  // namespace glenoid
