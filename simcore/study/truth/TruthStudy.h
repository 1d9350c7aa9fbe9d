// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>

#include "simcore/study/StudyTable.h"
#include "simcore/study/truth/TruthProblem.h"

namespace glenoid::truth {

struct TruthOptions {
  bool quick = false;
  Profile profile = Profile::Direct;
  std::optional<Elements> elements;      ///< only these; without it both, where they make a difference
  std::vector<std::string> only;         ///< ids; empty: all
  double stiffness = 1;                  ///< TruthSetup::stiffness
  int threads = 1;                       ///< solves at a time; the figures are the same
  std::function<bool(double)> progress;  ///< share of what is done; false stops
};

struct TruthPoint {
  double size = 0;
  TruthValue found;
  double seconds = 0;   ///< thread CPU time
  std::string failure;  ///< why there is no figure; empty: there is
};

/// One problem with one kind of elements.
struct TruthVerdict {
  const TruthProblem* problem = nullptr;
  Elements elements = Elements::Tetrahedra;
  std::vector<TruthPoint> points;  ///< from coarse to fine
  double bar = 0, orderBar = 0;    ///< what is asked for
  double order = 0;  ///< slope of log error over log size by least squares; NaN where nothing but round-off
                     ///< is left, or one point
  bool withinBar = false, orderHeld = true;
  bool met() const { return withinBar && orderHeld; }
};

/// Fails with UnknownId for an id in `only` that is none, and with Cancelled.
Result<std::vector<TruthVerdict>> runTruth(const TruthOptions& options);

/// truth: a row for each solve. truth-summary: a row for each verdict.
StudyTable truthTable(std::span<const TruthVerdict> verdicts);
StudyTable truthSummary(std::span<const TruthVerdict> verdicts);

const char* elementsWord(Elements elements);

}  // namespace glenoid::truth
