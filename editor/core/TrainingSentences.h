// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QString>
#include <optional>

#include "simcore/scene/Scenario.h"
#include "simcore/train/TrainingReport.h"

namespace glenoid {

/// A metric in words, with the tool or limit it is of: "Probe: length of the path".
QString metricWords(const std::string& metric, const Scenario& scenario);

/// Its value with the unit that people read (mm, s, N …); a dash where there is none.
QString metricFigure(const std::string& metric, const std::optional<double>& value);

/// Its formula, what its figures are of, and whether anybody found it to tell skilled people from others.
QString metricFormula(const std::string& metric);

/// What is open, done or missed, in one word.
QString outcomeWord(TaskOutcome outcome);

/// The name of a task, or its id where it has none.
QString taskName(const TaskResult& task);

/// How it went as a whole, in one sentence.
QString trainingSentence(const TrainingReport& report);

}  // namespace glenoid
