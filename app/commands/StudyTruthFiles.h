// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <span>
#include <string>
#include <vector>

#include "app/plot/LogLogPlot.h"
#include "simcore/base/Error.h"
#include "simcore/study/truth/TruthStudy.h"

namespace glenoid {

/// What another program says of one problem.
struct TruthOther {
  std::string problem;
  double value = 0, error = 0;  ///< in the problem's unit; as a share of what is known
};

/// CalculiX on those of these problems that are written for it, its files in a folder of that name; empty
/// where the program is not installed.
std::vector<TruthOther> truthByCalculix(std::span<const truth::TruthVerdict> verdicts,
                                        const std::string& folder);

/// Error over refinement of one problem, its bars and its order; `verdicts`: of that problem, one for each
/// kind of elements.
LogLogPlot truthPlot(std::span<const truth::TruthVerdict> verdicts, std::span<const TruthOther> others,
                     const std::string& machine);

/// One line for each verdict, what is missed, and what another program says.
std::string truthSummaryText(std::span<const truth::TruthVerdict> verdicts,
                             std::span<const TruthOther> others);

/// truth.csv, truth.json, summary.txt and for each problem PROBLEM.png, .svg, .pdf. Fails as writing does.
Result<Done> writeTruth(const std::string& folder, std::span<const truth::TruthVerdict> verdicts,
                        std::span<const TruthOther> others, const truth::TruthOptions& options);

/// scenes/PROBLEM.joint and .scenario.json of each that can be said so, with the finest size that was solved;
/// what it is, is its description.
Result<Done> writeTruthScenes(const std::string& folder, std::span<const truth::TruthVerdict> verdicts,
                              const truth::TruthOptions& options);

}  // namespace glenoid
