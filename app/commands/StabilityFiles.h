// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <span>
#include <string>

#include "simcore/base/Error.h"
#include "simcore/scene/Recording.h"
#include "simcore/study/StabilityStudy.h"

namespace glenoid {

/// What the gauntlet leaves behind, and the way back from it.

/// A line for each case: how many trials held, and the worst figure of each kind.
StudyTable stabilitySummary(std::span<const StabilityVerdict> verdicts);

/// Why a trial did not hold, one whole sentence for each bound that it broke.
std::string stabilitySentences(const StabilityVerdict& verdict);

/// What a person reads: summary, what did not hold and why, and every trial in one line. `scene`: as it was named.
std::string stabilityText(std::span<const StabilityVerdict> verdicts, const StabilityOptions& options, const std::string& scene);

/// Writes stability.csv, stability.json and stability.txt. Fails with FileUnwritable.
Result<Done> writeStability(const std::string& folder, std::span<const StabilityVerdict> verdicts, const StabilityOptions& options,
                            const std::string& scene);

/// Of a trial that did not hold, counted or not: TRIAL.png (where pictures can be drawn) and TRIAL.recording; `paper` beside
/// another profile as TRIAL.paper.…. Fails with FileUnwritable.
Result<Done> writeFailure(const std::string& folder, const StabilityVerdict& verdict, const std::string& scene);

/// The trial that a recording of the gauntlet repeats: a mark "gauntlet: ID" says it. Nothing in other recordings.
std::optional<std::string> stabilityTrialIn(const Recording& recording);

/// A trial as a recording has it, made ready to be run again with as many steps.
struct StabilityAgain {
  std::unique_ptr<StabilityStage> stage;
  StabilityTrial trial;
  StabilityRun run;
};
/// Fails as the gauntlet does, with UnknownId where this build has no such trial.
Result<StabilityAgain> openStabilityAgain(const Recording& recording);

/// Repeats it with as many steps, and answers the verdict. Fails as the gauntlet does, with UnknownId where this build has no such trial.
Result<StabilityVerdict> repeatStability(const Recording& recording);

/// SCENARIO or JOINT of the command line, made ready for the gauntlet.
Result<StabilityScene> openStabilityScene(const std::string& word);

}  // namespace glenoid
