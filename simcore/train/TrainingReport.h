// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "simcore/file/JsonValue.h"
#include "simcore/scene/training/Training.h"
#include "simcore/train/Metric.h"
#include "simcore/train/TaskJudge.h"

namespace glenoid {

struct TaskResult {
  std::string id, name;
  TaskKind kind = TaskKind::Touch;
  TaskRecord record;
  std::string tool;              ///< id of who did it; may be empty
  double score = 0;              ///< taskScore
};

/// A row of the form with what it gave.
struct FormResult {
  FormRow row;
  std::optional<double> value;   ///< nothing: nothing was measured, and no point is given
  double points = 0;
};

/// A metric beside what others reached.
struct ReferenceResult {
  ReferenceFigure figure;
  std::optional<double> z;
};

struct BenchmarkResult {
  Benchmark benchmark;
  std::optional<double> value;
  bool kept = false;             ///< not above the limit
};

/// How a training went, at the end or so far. SI units.
struct TrainingReport {
  std::vector<TaskResult> tasks; ///< in the scenario's order
  std::vector<Metric> metrics;   ///< in the order of metricKinds() within each tool and limit
  std::vector<FormResult> form;
  std::vector<ReferenceResult> references;
  std::vector<BenchmarkResult> benchmarks;
  double score = 0;              ///< 0…100: share of the form's points
  bool passed = false;           ///< score ≥ passScore and no task is left
  bool finished = false;         ///< no task is left to do

  /// Value of a metric by its name.
  std::optional<double> value(const std::string& metric) const;
};

/// Fills form, references, benchmarks, score and passed from tasks and metrics.
void scoreTraining(const Training& training, TrainingReport& report);

/// Members "tasks" and "training" of a run report (resources/schemas/run-report.schema.json).
JsonValue tasksJson(const TrainingReport& report);
JsonValue trainingJson(const TrainingReport& report);

const char* taskKindName(TaskKind kind);
const char* outcomeName(TaskOutcome outcome);  ///< "waiting", "open", "done", "missed"

}  // namespace glenoid
