// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/train/TrainingReport.h"

#include <algorithm>

#include "simcore/file/JsonObject.h"
#include "simcore/scene/training/TrainingWords.h"

namespace glenoid {
namespace {

JsonValue orNull(const std::optional<double>& value) { return value ? JsonValue(*value) : JsonValue(); }

std::optional<double> meanForce(const TaskRecord& record) {
  if (!(record.touchSeconds > 0)) return std::nullopt;
  return record.forceSum / record.touchSeconds;
}

}  // namespace

const char* taskKindName(TaskKind kind) { return scene_words::wordOf(scene_words::kTaskKinds, kind); }

const char* outcomeName(TaskOutcome outcome) {
  switch (outcome) {
    case TaskOutcome::Waiting: return "waiting";
    case TaskOutcome::Open: return "open";
    case TaskOutcome::Done: return "done";
    case TaskOutcome::Missed: return "missed";
  }
  return "";
}

std::optional<double> TrainingReport::value(const std::string& metric) const {
  for (const Metric& entry : metrics)
    if (entry.name == metric) return entry.value;
  return std::nullopt;
}

void scoreTraining(const Training& training, TrainingReport& report) {
  report.form.clear();
  report.references.clear();
  report.benchmarks.clear();
  double points = 0, all = 0;
  for (const FormRow& row : training.form.empty() ? defaultForm() : training.form) {
    FormResult result{row, report.value(row.metric), 0};
    if (result.value) result.points = row.points * std::clamp((row.worst - *result.value) / (row.worst - row.best), 0.0, 1.0);
    points += result.points;
    all += row.points;
    report.form.push_back(std::move(result));
  }
  for (const ReferenceFigure& figure : training.references) {
    const auto value = report.value(figure.metric);
    report.references.push_back({figure, value ? std::optional((*value - figure.mean) / figure.sd) : std::nullopt});
  }
  for (const Benchmark& benchmark : training.benchmarks) {
    const auto value = report.value(benchmark.metric);
    report.benchmarks.push_back({benchmark, value, value && *value <= benchmark.limit});
  }
  report.score = all > 0 ? 100 * points / all : 0;
  report.finished = std::all_of(report.tasks.begin(), report.tasks.end(), [](const TaskResult& task) {
    return task.record.outcome == TaskOutcome::Done || task.record.outcome == TaskOutcome::Missed;
  });
  report.passed = report.finished && report.score >= training.passScore;
}

JsonValue tasksJson(const TrainingReport& report) {
  JsonValue list = JsonValue::array();
  for (const TaskResult& task : report.tasks) {
    const TaskRecord& record = task.record;
    JsonValue metrics = jsonObject({{"time", record.ended ? JsonValue(*record.ended - *record.opened) : JsonValue()},
                                    {"errors", record.errors},
                                    {"distance", orNull(record.distance)},
                                    {"depth", orNull(record.depth)},
                                    {"forceMax", record.forceMax},
                                    {"forceMean", orNull(meanForce(record))},
                                    {"touchSeconds", record.touchSeconds},
                                    {"seenSeconds", record.seenSeconds}});
    list.append(jsonObject({{"id", task.id},
                            {"name", task.name},
                            {"kind", taskKindName(task.kind)},
                            {"done", record.outcome == TaskOutcome::Done},
                            {"outcome", outcomeName(record.outcome)},
                            {"tool", task.tool},
                            {"opened", orNull(record.opened)},
                            {"ended", orNull(record.ended)},
                            {"progress", record.progress},
                            {"score", task.score},
                            {"metrics", std::move(metrics)}}));
  }
  return list;
}

JsonValue trainingJson(const TrainingReport& report) {
  JsonValue metrics = JsonValue::array(), form = JsonValue::array(), references = JsonValue::array(), benchmarks = JsonValue::array();
  for (const Metric& metric : report.metrics) {
    JsonValue entry = jsonObject({{"name", metric.name}, {"value", orNull(metric.value)}});
    if (const MetricKind* kind = metricKind(metric.name)) {
      entry.set("unit", kind->unit);
      entry.set("formula", kind->formula);
      entry.set("status", *kind->evidence ? "validated" : "experimental");
    }
    metrics.append(std::move(entry));
  }
  for (const FormResult& result : report.form)
    form.append(jsonObject({{"metric", result.row.metric}, {"value", orNull(result.value)}, {"best", result.row.best}, {"worst", result.row.worst},
                            {"points", result.points}, {"of", result.row.points}}));
  for (const ReferenceResult& result : report.references)
    references.append(jsonObject({{"metric", result.figure.metric}, {"mean", result.figure.mean}, {"sd", result.figure.sd}, {"count", result.figure.count},
                                  {"source", result.figure.source}, {"z", orNull(result.z)}}));
  for (const BenchmarkResult& result : report.benchmarks)
    benchmarks.append(jsonObject({{"metric", result.benchmark.metric}, {"name", result.benchmark.name}, {"limit", result.benchmark.limit},
                                  {"source", result.benchmark.source}, {"value", orNull(result.value)}, {"kept", result.kept}}));
  return jsonObject({{"score", report.score}, {"passed", report.passed}, {"finished", report.finished}, {"metrics", std::move(metrics)}, {"form", std::move(form)},
                     {"references", std::move(references)}, {"benchmarks", std::move(benchmarks)}});
}

}  // namespace glenoid
