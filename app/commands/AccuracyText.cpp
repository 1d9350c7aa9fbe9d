// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/AccuracyText.h"

#include <algorithm>
#include <cmath>

#include "app/commands/Console.h"
#include "editor/core/Sentences.h"

namespace glenoid {
namespace {

bool isLength(AccuracyQuantity quantity) { return quantity == AccuracyQuantity::Displacement || quantity == AccuracyQuantity::Penetration; }

/// In what a person reads: millimetres or newtons.
double inUnits(AccuracyQuantity quantity, double value) { return isLength(quantity) ? 1e3 * value : value; }

std::string failureWords(const AccuracyFailure& failure) {
  if (failure.reason == "not-built") return sentenceOf(failure.error).toStdString();
  const std::string count = text("in %ld of %ld steps", failure.count, failure.of);
  return (failure.reason == "diverged" ? "diverged " : "not finite ") + count;
}

/// The fewest milliseconds (p95 of work) among settings that may be chosen.
std::optional<std::size_t> extreme(const AccuracyResult& result, const AccuracyView& view, bool byWork) {
  std::optional<std::size_t> found;
  const auto figure = [&](std::size_t k) { return byWork ? result.rows[k].work.p95 : *errorIn(result.rows[k], view); };
  for (std::size_t k = 0; k < result.rows.size(); ++k) {
    const AccuracyRow& row = result.rows[k];
    if (!errorIn(row, view) || row.windows != static_cast<int>(result.windows.size()) || !fitsScenario(row.setting)) continue;
    if (!found || figure(k) < figure(*found)) found = k;
  }
  return found;
}

std::string familyWords(const std::string& family) {
  if (family == "scene") return "the scene as it is";
  if (family == "time-step") return "time step";
  if (family == "profile") return "profile";
  if (family == "elements") return "elements";
  if (family == "cells") return "finer cells";
  if (family == "surfaces") return "visual surfaces touch (a difference of models, no error)";
  if (family == "contact") return "contact distance, recovery speed";
  if (family == "paper") return "variants of profile paper";
  return family;
}

std::string againstWords(const AccuracyResult& result, AccuracyAgainst against) {
  const AccuracyReference& reference = result.reference(against);
  if (against == AccuracyAgainst::OwnCells)
    return text("the same scene in its own cells with steps of %.3g ms", 1e3 * reference.finest.dt);
  return text("the same scene with %.3g times the tetrahedra (%ld) and steps of %.3g ms", reference.finest.cells, reference.tetrahedra, 1e3 * reference.finest.dt);
}

std::string lineOf(const AccuracyResult& result, const AccuracyRow& row, const AccuracyView& view) {
  std::string line = text("  %-44s %8.3g ms (p95 %.3g, p99 %.3g)  %s", row.setting.id.c_str(), row.work.median, row.work.p95, row.work.p99,
                          quantityText(view.quantity, *errorIn(row, view)).c_str());
  if (row.setting.dt != result.scene.dt) line += text("; one step of %.3g ms takes %.3g ms", 1e3 * row.setting.dt, row.cpu.median);
  return line + "\n";
}

}  // namespace

std::string quantityWords(AccuracyQuantity quantity) {
  switch (quantity) {
    case AccuracyQuantity::Displacement: return "displacement";
    case AccuracyQuantity::ContactForce: return "contact force";
    case AccuracyQuantity::Penetration: return "penetration";
    case AccuracyQuantity::HandForce: return "force on the hand";
  }
  return "";
}

std::string quantityText(AccuracyQuantity quantity, double value) {
  return text(isLength(quantity) ? "%.3g mm" : "%.3g N", inUnits(quantity, value));
}

Result<std::optional<std::size_t>> chosenSetting(const AccuracyResult& result, const AccuracyWish& wish) {
  if (!wish.budgetMs && !wish.accuracy) return std::optional<std::size_t>();
  if (result.reference(wish.view.against).missing) return *result.reference(wish.view.against).missing;
  const std::string what = quantityWords(wish.view.quantity);
  if (wish.accuracy) {
    const double least = leastAccuracy(result, wish.view);
    if (*wish.accuracy < least)
      return Error{Fault::OutOfRange, {}, {quantityText(wish.view.quantity, *wish.accuracy) + " for --accuracy",
                                          quantityText(wish.view.quantity, least) + " (twice the " + what + " error of the study’s own reference)", "any"}, "study"};
    if (const auto found = pickForAccuracy(result, wish.view, *wish.accuracy)) return found;
    const auto best = extreme(result, wish.view, false);
    if (!best) return Error{Fault::CheckFailed, {}, {"no setting of this study has an error to choose by"}, "study"};
    return Error{Fault::CheckFailed, {}, {"no setting has a " + what + " error of " + quantityText(wish.view.quantity, *wish.accuracy) + " or less; the best, " +
                                          result.rows[*best].setting.id + ", has " + quantityText(wish.view.quantity, *errorIn(result.rows[*best], wish.view))}, "study"};
  }
  if (const auto found = pickForBudget(result, wish.view, *wish.budgetMs)) return found;
  const auto best = extreme(result, wish.view, true);
  if (!best) return Error{Fault::CheckFailed, {}, {"no setting of this study has an error to choose by"}, "study"};
  return Error{Fault::CheckFailed, {}, {text("no setting stays within %.3g ms in 95 of 100 steps; the cheapest, %s, takes %.3g ms", *wish.budgetMs,
                                             result.rows[*best].setting.id.c_str(), result.rows[*best].work.p95)}, "study"};
}

std::string accuracySummary(const AccuracyResult& result, const std::string& scene, const AccuracyView& view, std::optional<std::size_t> chosen) {
  const double stepMs = 1e3 * result.scene.dt;
  std::string out = text("Scene %s: %zu windows of %.3g s, friction %s; %d repeats of the timing, interleaved.\n", scene.c_str(), result.windows.size(),
                         result.wishes.seconds, result.friction ? "on" : "off", result.repeats);
  for (const AccuracyAgainst against : {AccuracyAgainst::OwnCells, AccuracyAgainst::FinerCells}) {
    const AccuracyReference& reference = result.reference(against);
    if (reference.missing) {
      out += text("No comparison with %s: %s\n", againstKey(against), sentenceOf(*reference.missing).toStdString().c_str());
      continue;
    }
    out += text("Reference %s: %s. Its own error:", againstKey(against), againstWords(result, against).c_str());
    for (int q = 0; q < kAccuracyQuantities; ++q) {
      const auto quantity = static_cast<AccuracyQuantity>(q);
      if (quantity == AccuracyQuantity::HandForce && !result.hands) continue;
      out += text("%s %s %s", q ? "," : "", quantityWords(quantity).c_str(), quantityText(quantity, reference.floor[quantity].value).c_str());
    }
    out += ".\n";
  }
  const auto& rows = result.rows;
  if (!rows.empty() && rows[0].errors[0] && rows[0].failure.reason.empty()) {
    const AccuracyReference& reference = result.reference(AccuracyAgainst::FinerCells);
    const AccuracyError& error = (*rows[0].errors[0])[AccuracyQuantity::Displacement];
    out += text("What the scene's cells leave out: %s of displacement (%s), known to %s.\n", quantityText(AccuracyQuantity::Displacement, error.value).c_str(),
                error.where.c_str(), quantityText(AccuracyQuantity::Displacement, reference.floor[AccuracyQuantity::Displacement].value).c_str());
  }
  out += text("\nNo other setting is both faster and nearer to the reference in its %s (%s); ms of computing for each %.3g ms that are simulated:\n",
              quantityWords(view.quantity).c_str(), againstKey(view.against), stepMs);
  const std::vector<std::size_t> front = paretoFront(result, view);
  for (const std::size_t k : front) out += lineOf(result, rows[k], view);
  const double floor = result.reference(view.against).floor[view.quantity].value;
  if (!front.empty() && *errorIn(rows[front.front()], view) <= floor)  // the fastest has the largest error of the front
    out += "  All of these lie within the reference’s own error, " + quantityText(view.quantity, floor) + ": by this nothing can be told apart.\n";
  long failed = 0;
  for (const AccuracyRow& row : rows) failed += !row.failure.reason.empty();
  if (failed > 0) out += "\nNo error can be given for:\n";
  for (const AccuracyRow& row : rows)
    if (!row.failure.reason.empty()) out += text("  %-44s %s\n", row.setting.id.c_str(), failureWords(row.failure).c_str());
  if (chosen) out += "\nChosen:\n" + lineOf(result, rows[*chosen], view);
  return out;
}

LogLogPlot accuracyPlot(const AccuracyResult& result, const std::string& scene, const AccuracyView& view, std::optional<std::size_t> chosen,
                        const std::string& machine) {
  const AccuracyReference& reference = result.reference(view.against);
  const double stepMs = 1e3 * result.scene.dt;
  LogLogPlot plot;
  plot.title = "What accuracy costs: " + quantityWords(view.quantity) + ", " + scene;
  plot.subtitle = {"Error against " + againstWords(result, view.against) + ": root mean square over " +
                       text("%zu windows of %.3g s each, of the part, pair or tool for which it is largest.", result.windows.size(), result.wishes.seconds),
                   text("Time: thread CPU, median of %d interleaved repeats, whiskers up to p95. Hollow: compared in fewer windows, since it is slow. ", result.repeats) +
                       "Lower left is better.",
                   machine + "."};
  if (view.against == AccuracyAgainst::OwnCells) plot.subtitle.back() += " Settings with other cells, elements or surfaces are other models: see the plot against finer cells.";
  plot.xTitle = "Error of " + quantityWords(view.quantity) + (isLength(view.quantity) ? ", mm" : ", N");
  plot.yTitle = text("Computing time for each %.3g ms that are simulated, ms", stepMs);
  const double floor = reference.floor[view.quantity].value;
  plot.band = inUnits(view.quantity, floor);
  plot.bandLabel = "below the reference’s own error: no difference can be told";
  plot.limit = 2 * plot.band;
  plot.limitLabel = "twice that: least --accuracy";
  for (const double ms : {1.0, 5.0, 20.0}) plot.levels.push_back({ms, text(ms == stepMs ? "%g ms (real time)" : "%g ms", ms)});
  if (stepMs != 1 && stepMs != 5 && stepMs != 20) plot.levels.push_back({stepMs, text("%.3g ms (real time)", stepMs)});

  // What has no error at all has no place on a logarithmic axis; it stands left of the least that there is.
  double least = plot.band > 0 ? plot.band : 1e300;
  for (const AccuracyRow& row : result.rows)
    if (const auto error = errorIn(row, view); error && *error > 0) least = std::min(least, inUnits(view.quantity, *error));
  const auto placeOf = [&](double error) { return error > 0 ? inUnits(view.quantity, error) : least < 1e300 ? 0.5 * least : 1e-3; };

  const std::vector<std::size_t> front = paretoFront(result, view);
  plot.marginTitle = "No error to draw";
  for (std::size_t k = 0; k < result.rows.size(); ++k) {
    const AccuracyRow& row = result.rows[k];
    if (!row.failure.reason.empty()) {
      const double height = row.timed > 0 ? row.work.median : std::nan("");
      plot.margin.push_back({height, row.setting.id, failureWords(row.failure)});
      continue;
    }
    const auto error = errorIn(row, view);
    if (!error) continue;  // has no place in this view: it is a model of other cells
    auto series = std::find_if(plot.series.begin(), plot.series.end(), [&](const PlotSeries& s) { return s.name == familyWords(row.setting.family); });
    if (series == plot.series.end()) series = plot.series.insert(series, PlotSeries{familyWords(row.setting.family), {}});
    PlotPoint point{placeOf(*error), row.work.median, row.setting.id, row.work.p95};
    if (*error == 0) point.label += " (no error)";
    point.important = std::find(front.begin(), front.end(), k) != front.end() || k == chosen || k == 0;
    if (k == chosen) point.label += " (chosen)";
    point.hollow = row.windows != static_cast<int>(result.windows.size());
    series->points.push_back(std::move(point));
  }
  PlotSeries line{"no other is both faster and nearer", {}, true, false};
  for (const std::size_t k : front) line.points.push_back({placeOf(*errorIn(result.rows[k], view)), result.rows[k].work.median});
  plot.series.push_back(std::move(line));
  return plot;
}

}  // namespace glenoid
