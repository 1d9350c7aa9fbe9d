// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/Outcome.h"

#include "app/commands/Console.h"
#include "editor/core/EffectSentences.h"
#include "editor/core/NoticeSentences.h"
#include "editor/core/Sentences.h"
#include "simcore/file/Json.h"
#include "simcore/scene/RecordingFile.h"

namespace glenoid {
namespace {

/// What became of a device in a run.
std::string deviceSentence(const LiveHandReport& live, const std::string& tool) {
  if (!live.heard) return "The device “" + live.device + "” never said where its hand is: “" + tool + "” stayed where it began, and nothing was felt.";
  if (live.lostSeconds <= 0) return "The device “" + live.device + "” held “" + tool + "” all the time.";
  return text("The device “%s” was gone, silent or wild for %.3f s in all, from %.2f s on: no force was shown meanwhile, and “%s” stayed where it was.",
              live.device.c_str(), live.lostSeconds, live.lostFrom, tool.c_str());
}

}  // namespace

namespace {

std::string figureOf(const Metric& metric) {
  const MetricKind* kind = metricKind(metric.name);
  const std::string unit = kind && std::string(kind->unit) != "1" ? std::string(" ") + kind->unit : std::string();
  return metric.value ? text("%.4g", *metric.value) + unit : std::string("–");
}

std::string trainingSummary(const TrainingReport& training) {
  std::string out;
  for (const TaskResult& task : training.tasks) {
    out += text("task:        %s: %s", task.id.c_str(), outcomeName(task.record.outcome));
    if (task.record.outcome == TaskOutcome::Done)
      out += text(" after %.1f s, score %.2f", *task.record.ended - *task.record.opened, task.score);
    if (task.record.errors > 0) out += text(", %d errors", task.record.errors);
    out += "\n";
  }
  for (const Metric& metric : training.metrics) out += text("metric:      %s ", metric.name.c_str()) + figureOf(metric) + "\n";
  for (const ReferenceResult& result : training.references)
    if (result.z) out += text("reference:   %s lies %+.1f standard deviations from the mean of %d runs\n", result.figure.metric.c_str(), *result.z, result.figure.count);
  for (const BenchmarkResult& result : training.benchmarks)
    out += text("benchmark:   %s at most %g: %s (%s)\n", result.benchmark.metric.c_str(), result.benchmark.limit,
                !result.value ? "not measured" : result.kept ? "kept" : "not kept", result.benchmark.source.c_str());
  return out + text("score:       %.1f of 100, %s\n", training.score, training.passed ? "passed" : training.finished ? "not passed" : "not finished");
}

}  // namespace

namespace {

/// Why an effect is on or off; empty where the model does not know it.
std::string whyOf(const EffectReport& effect, const Model& model) {
  for (EffectFacts& facts : effectFacts(model)) {
    if (facts.name != effect.name) continue;
    facts.on = effect.state == "on";
    if (facts.on) facts.reason = effect.reason;  // haptics was switched on by the run
    return effectSentence(facts).toStdString();
  }
  return {};
}

}  // namespace

Result<Done> saveOutcome(const RunReport& report, const Model& model, const std::string& path) {
  Result<JsonValue> json = parseJson(toJson(report, [](const Notice& notice) { return sentenceOf(notice).toStdString(); }), path);
  if (!json) return json.error();
  JsonValue effects = JsonValue::array();
  for (std::size_t k = 0; k < report.effects.size(); ++k) {
    JsonValue effect = (*json)["effects"][k];
    effect.set("why", whyOf(report.effects[k], model));
    effects.append(std::move(effect));
  }
  json->set("effects", std::move(effects));
  return writeJson(path, *json);
}

Result<Done> saveOutcome(const Recording& recording, const std::string& path) { return saveRecording(recording, path); }

std::string summaryOf(const RunReport& r, const Model& model) {
  std::string out = text("%s: %ld steps of %g ms, %s, %s\n", r.scenario.c_str(), r.steps, r.dt * 1e3, r.profile.c_str(),
                         r.finite ? "finite" : "NOT FINITE");
  if (r.rejectedSteps > 0) out += text("rejected:    %ld steps were not finite and not taken\n", r.rejectedSteps);
  if (r.diverged) out += text("diverged:    the splitting diverged in %ld steps\n", r.paper ? r.paper->divergedSteps : 0L);
  out += text("step:        %.3f ms median, %.3f ms at the 99th percentile (CPU); %.0f steps/s, %.1f times real time "
              "(%.1f by CPU time)\n",
              r.step.median, r.step.p99, r.stepsPerSecond, r.stepsPerSecond * r.dt, r.stepsPerCpuSecond * r.dt);
  out += "contacts:    " + (r.contacts.rest ? text("%.1f at rest (%.1f press), ", *r.contacts.rest, *r.contacts.pressingRest) : std::string()) +
         text("%.1f mean (%.1f), %d max (%d); %d contact islands max\n", r.contacts.mean, r.contacts.pressingMean, r.contacts.max,
              r.contacts.pressingMax, r.contactIslandsMax);
  out += text("penetration: %.3f mm", r.penetrationMax * 1e3) +
         (r.penetrationPair.empty() ? std::string() : " (" + r.penetrationPair + ")") +
         (r.visualPenetrationMax ? text("; visual surfaces %.3f mm", *r.visualPenetrationMax * 1e3) : std::string()) +
         (r.visualPenetrationPair.empty() ? std::string() : " (" + r.visualPenetrationPair + ")") + "\n";
  out += text("residual:    %.2e\n", r.residual);
  std::string cells;
  for (const PartReport& part : r.parts)
    if (part.cells > 0) cells += (cells.empty() ? "" : ", ") + text("%d in ", part.cells) + part.id;
  if (!cells.empty()) out += "cells:       " + cells + "\n";
  if (r.tissueLaw == "linear") out += "tissue:      the linear law at any stretch, as published: overstretched tissue may turn inside out\n";
  if (r.paper)
    out += text("paper:       D by node in %ld steps, by object in %ld; outer iterations %.1f mean, %d max, residual %.1e; "
                "capped in %ld steps\n",
                r.paper->nodeSteps, r.paper->objectSteps, r.paper->outerIterationsMean, r.paper->outerIterationsMax,
                r.paper->outerResidualMax, r.paper->outerCappedSteps);
  if (r.paper && !r.paper->departures.empty()) {
    out += "             not as published: ";
    for (std::size_t i = 0; i < r.paper->departures.size(); ++i)
      out += (i ? "; " : "") + paperDeparture(r.paper->departures[i]).toStdString();
    out += "\n";
  }
  if (r.haptic) {
    const HapticReport& h = *r.haptic;
    out += text("haptics:     %.2f Hz, %s scheduling, late by %.3f ms at the 99th percentile, %.3f at the 99.9th, %.3f at most; %ld of %ld ticks missed\n",
                h.rateHz, h.realTimeScheduling ? "real-time" : "ordinary", h.latenessP99Ms, h.latenessP999Ms, h.latenessMaxMs, h.missed, h.ticks + h.missed);
    for (const HapticToolReport& tool : h.tools) {
      out += text("             %s: %.0f N/m of at most %.0f%s, %.2f N max, %.3f mJ made", tool.tool.c_str(), tool.stiffness, tool.bound,
                  tool.saturated ? " (the scenario asks for more than the device can show)" : "", tool.forceMaxN, 1e3 * tool.energyMaxJ);
      if (tool.forceErrorRms) out += text(", %.4f N RMS off the exact step, of %.3f N", *tool.forceErrorRms, *tool.forceRms);
      out += "\n";
      if (tool.live) out += "             " + deviceSentence(*tool.live, tool.tool) + "\n";
    }
  }
  for (const EffectReport& effect : r.effects) out += "effect:      " + effectName(effect.name).toStdString() + " " + whyOf(effect, model) + "\n";
  for (const MarkReport& mark : r.marks)
    if (mark.begin < r.seconds)
      out += text("%-28s %.2f s at 1 N or more, %.2f N max\n", (mark.name + ":").c_str(), mark.seconds, mark.forceMax);
  if (r.training) out += trainingSummary(*r.training);
  for (const Notice& notice : r.notices) out += "notice:      " + sentenceOf(notice).toStdString() + "\n";
  return out + "state:       " + r.stateHash + "\n";
}

}  // namespace glenoid
