// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <string>
#include <vector>

#include "simcore/study/ContactState.h"
#include "simcore/study/StepCost.h"
#include "simcore/study/StudyTable.h"

namespace glenoid {

/// How thorough a benchmark is.
struct BenchOptions {
  std::vector<ContactWish> contacts{{65, 25, 1.5}, {153, 60, 1.5}};  ///< states to look for: under half as much tone again as ships
  std::vector<int> tetrahedra{750, 7'500, 75'000};        ///< sizes of the growth table
  Repeats fast{50, 4000, 15};                             ///< a profile that takes about a millisecond
  Repeats slow{2, 200, 8};                                ///< paper and reference
  Repeats grown{2, 400, 25};                              ///< each size of the growth table
  std::function<bool(const std::string& section, double fraction)> progress;  ///< false cancels
};

/// Everything within one or two minutes: fewer repetitions, no 75 000 tetrahedra.
BenchOptions quickBench();

/// One part of the benchmark; answers one table or several.
struct BenchSection {
  std::string id;
  std::function<Result<std::vector<StudyTable>>(const StudyScene& scene, const BenchOptions& options)> run;
};

/// The sections of simcore, in the order in which they are shown. A section of another layer (a peer in a process of
/// its own) is appended by whoever composes the benchmark.
std::vector<BenchSection> benchSections();

/// States and profiles: whole step, solve alone, error against `reference`; and the stages of each.
Result<std::vector<StudyTable>> benchProfiles(const StudyScene& scene, const BenchOptions& options);
/// The same states with the effect friction on, beside the step without; a reason where it cannot be on.
Result<std::vector<StudyTable>> benchFriction(const StudyScene& scene, const BenchOptions& options);
/// The same with the effect bursa.
Result<std::vector<StudyTable>> benchBursa(const StudyScene& scene, const BenchOptions& options);
/// The same joint in finer and finer cells: time, contacts, memory, exponents.
Result<std::vector<StudyTable>> benchGrowth(const StudyScene& scene, const BenchOptions& options);

}  // namespace glenoid
