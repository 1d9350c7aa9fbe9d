// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/truth/TruthStudy.h"

#include <time.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <thread>

namespace glenoid::truth {

namespace {

constexpr double kRoundOff = 1e-10;  ///< errors below it have no order

double cpuSeconds() {
  timespec now{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

double fittedOrder(const std::vector<TruthPoint>& points) {
  double n = 0, x = 0, y = 0, xx = 0, xy = 0;
  for (const TruthPoint& point : points) {
    if (!point.failure.empty() || !(point.found.error > kRoundOff)) continue;
    const double a = std::log(point.size), b = std::log(point.found.error);
    n += 1, x += a, y += b, xx += a * a, xy += a * b;
  }
  return n < 2 ? std::numeric_limits<double>::quiet_NaN() : (n * xy - x * y) / (n * xx - x * x);
}

void judge(TruthVerdict& verdict) {
  verdict.order = fittedOrder(verdict.points);
  const TruthPoint& finest = verdict.points.back();
  verdict.withinBar = finest.failure.empty() && finest.found.error <= verdict.bar;
  for (const TruthPoint& point : verdict.points)
    verdict.withinBar = verdict.withinBar && point.failure.empty();
  // Two points make no order to judge by, and errors that are round-off have none.
  verdict.orderHeld = verdict.orderBar == 0 || verdict.points.size() < 3 || std::isnan(verdict.order) ||
                      verdict.order >= verdict.orderBar;
}

}  // namespace

const char* elementsWord(Elements elements) {
  return elements == Elements::Cells ? "cells" : "tetrahedra";
}

Result<std::vector<TruthVerdict>> runTruth(const TruthOptions& options) {
  for (const std::string& id : options.only)
    if (!findTruthProblem(id)) return Error{Fault::UnknownId, {}, {id, "problem"}, "truth"};
  std::vector<TruthVerdict> verdicts;
  for (const TruthProblem& problem : truthProblems()) {
    if (!options.only.empty() &&
        std::find(options.only.begin(), options.only.end(), problem.id) == options.only.end())
      continue;
    for (const Elements kind : {Elements::Tetrahedra, Elements::Cells}) {
      if (problem.byElements ? options.elements && *options.elements != kind : kind == Elements::Cells)
        continue;
      const TruthBar& bar = kind == Elements::Cells ? problem.cells : problem.tetrahedra;
      TruthVerdict& verdict = verdicts.emplace_back();
      verdict.problem = &problem;
      verdict.elements = kind;
      verdict.bar = options.quick ? bar.quick : bar.full;
      verdict.orderBar = bar.order;
      const std::size_t count = options.quick ? problem.quick : problem.sizes.size();
      for (std::size_t k = 0; k < count; ++k) verdict.points.push_back({problem.sizes[k], {}, 0, {}});
    }
  }
  struct Task {
    TruthVerdict* verdict;
    TruthPoint* point;
  };
  std::vector<Task> tasks;
  for (TruthVerdict& verdict : verdicts)
    for (TruthPoint& point : verdict.points) tasks.push_back({&verdict, &point});
  // The long ones are the finest; begun first they do not stand alone at the end.
  std::stable_sort(tasks.begin(), tasks.end(), [](const Task& a, const Task& b) {
    return a.point - a.verdict->points.data() > b.point - b.verdict->points.data();
  });
  std::atomic<std::size_t> next = 0, done = 0;
  std::atomic<bool> cancelled = false;
  const auto work = [&](bool tells) {
    for (std::size_t i = next++; i < tasks.size() && !cancelled; i = next++) {
      const auto [verdict, point] = tasks[i];
      const double before = cpuSeconds();
      const Result<TruthValue> found =
          verdict->problem->solve({verdict->elements, options.profile, options.stiffness}, point->size);
      point->seconds = cpuSeconds() - before;
      if (found) point->found = *found;
      if (!found)
        point->failure = found.error().detail.empty() ? "failed" : found.error().detail;
      else if (!std::isfinite(found->error))
        point->failure = "not finite";
      ++done;
      if (tells && options.progress &&
          !options.progress(static_cast<double>(done) / static_cast<double>(tasks.size())))
        cancelled = true;
    }
  };
  {
    std::vector<std::jthread> helpers;
    for (int n = 1; n < options.threads; ++n) helpers.emplace_back(work, false);
    work(true);
  }
  if (cancelled) return Error{Fault::Cancelled, {}, {}, "truth"};
  for (TruthVerdict& verdict : verdicts) judge(verdict);
  return verdicts;
}

StudyTable truthTable(std::span<const TruthVerdict> verdicts) {
  StudyTable table;
  table.id = "truth";
  table.columns = {"problem", "elements", "refined", "size", "sizeUnit", "found",
                   "known",   "unit",     "error",   "cpuS", "failure"};
  for (const TruthVerdict& verdict : verdicts)
    for (const TruthPoint& point : verdict.points) {
      const TruthProblem& p = *verdict.problem;
      const bool there = point.failure.empty();
      table.rows.push_back(
          {std::string(p.id),
           p.byElements ? StudyCell(std::string(elementsWord(verdict.elements))) : StudyCell(),
           std::string(p.refined), point.size, std::string(p.refinedUnit),
           there ? StudyCell(point.found.value) : StudyCell(), p.known, std::string(p.unit),
           there ? StudyCell(point.found.error) : StudyCell(), point.seconds,
           there ? StudyCell() : StudyCell(point.failure)});
    }
  return table;
}

StudyTable truthSummary(std::span<const TruthVerdict> verdicts) {
  StudyTable table;
  table.id = "truth-summary";
  table.columns = {"problem", "elements", "error", "bar", "order", "orderBar", "met", "cpuS"};
  for (const TruthVerdict& verdict : verdicts) {
    const TruthPoint& finest = verdict.points.back();
    double seconds = 0;
    for (const TruthPoint& point : verdict.points) seconds += point.seconds;
    table.rows.push_back(
        {std::string(verdict.problem->id),
         verdict.problem->byElements ? StudyCell(std::string(elementsWord(verdict.elements))) : StudyCell(),
         finest.failure.empty() ? StudyCell(finest.found.error) : StudyCell(), verdict.bar,
         std::isnan(verdict.order) ? StudyCell() : StudyCell(verdict.order),
         verdict.orderBar > 0 ? StudyCell(verdict.orderBar) : StudyCell(), verdict.met(), seconds});
  }
  return table;
}

}  // namespace glenoid::truth
