// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/train/TrainingReport.h"

#include <algorithm>

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
    JsonValue metrics = JsonValue::object();
    metrics.set("time", record.ended ? JsonValue(*record.ended - *record.opened) : JsonValue());
    metrics.set("errors", record.errors);
    metrics.set("distance", orNull(record.distance));
    metrics.set("depth", orNull(record.depth));
    metrics.set("forceMax", record.forceMax);
    metrics.set("forceMean", orNull(meanForce(record)));
    metrics.set("touchSeconds", record.touchSeconds);
    metrics.set("seenSeconds", record.seenSeconds);
    JsonValue json = JsonValue::object();
    json.set("id", task.id);
    json.set("name", task.name);
    json.set("kind", taskKindName(task.kind));
    json.set("done", record.outcome == TaskOutcome::Done);
    json.set("outcome", outcomeName(record.outcome));
    json.set("tool", task.tool);
    json.set("opened", orNull(record.opened));
    json.set("ended", orNull(record.ended));
    json.set("progress", record.progress);
    json.set("score", task.score);
    json.set("metrics", std::move(metrics));
    list.append(std::move(json));
  }
  return list;
}

JsonValue trainingJson(const TrainingReport& report) {
  JsonValue json = JsonValue::object();
  json.set("score", report.score);
  json.set("passed", report.passed);
  json.set("finished", report.finished);
  JsonValue metrics = JsonValue::array();
  for (const Metric& metric : report.metrics) {
    JsonValue entry = JsonValue::object();
    entry.set("name", metric.name);
    entry.set("value", orNull(metric.value));
    if (const MetricKind* kind = metricKind(metric.name)) {
      entry.set("unit", kind->unit);
      entry.set("formula", kind->formula);
      entry.set("status", *kind->evidence ? "validated" : "experimental");
    }
    metrics.append(std::move(entry));
  }
  json.set("metrics", std::move(metrics));
  JsonValue form = JsonValue::array();
  for (const FormResult& result : report.form) {
    JsonValue entry = JsonValue::object();
    entry.set("metric", result.row.metric);
    entry.set("value", orNull(result.value));
    entry.set("best", result.row.best);
    entry.set("worst", result.row.worst);
    entry.set("points", result.points);
    entry.set("of", result.row.points);
    form.append(std::move(entry));
  }
  json.set("form", std::move(form));
  JsonValue references = JsonValue::array();
  for (const ReferenceResult& result : report.references) {
    JsonValue entry = JsonValue::object();
    entry.set("metric", result.figure.metric);
    entry.set("mean", result.figure.mean);
    entry.set("sd", result.figure.sd);
    entry.set("count", result.figure.count);
    entry.set("source", result.figure.source);
    entry.set("z", orNull(result.z));
    references.append(std::move(entry));
  }
  json.set("references", std::move(references));
  JsonValue benchmarks = JsonValue::array();
  for (const BenchmarkResult& result : report.benchmarks) {
    JsonValue entry = JsonValue::object();
    entry.set("metric", result.benchmark.metric);
    entry.set("name", result.benchmark.name);
    entry.set("limit", result.benchmark.limit);
    entry.set("source", result.benchmark.source);
    entry.set("value", orNull(result.value));
    entry.set("kept", result.kept);
    benchmarks.append(std::move(entry));
  }
  json.set("benchmarks", std::move(benchmarks));
  return json;
}

}  // namespace glenoid
