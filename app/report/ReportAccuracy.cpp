// SPDX-License-Identifier: GPL-3.0-or-later
#include <QCoreApplication>
#include <QLocale>
#include <algorithm>
#include <cmath>

#include "app/report/StudyReport.h"
#include "editor/lab/AccuracyPoints.h"
#include "editor/lab/SettingWords.h"

namespace glenoid {
namespace {

struct AccuracyTexts {
  Q_DECLARE_TR_FUNCTIONS(glenoid::ReportAccuracy)
};

constexpr AccuracyQuantity kQuantities4[] = {AccuracyQuantity::Displacement, AccuracyQuantity::ContactForce, AccuracyQuantity::Penetration, AccuracyQuantity::HandForce};

QString capital(QString words) {
  if (!words.isEmpty()) words[0] = words[0].toUpper();
  return words;
}

bool measuredIn(const AccuracyPoints& points) {
  return points.missing.empty() && std::any_of(points.points.begin(), points.points.end(), [](const AccuracyPoint& point) { return std::isfinite(point.error); });
}

const AccuracyPoint* sceneItself(const AccuracyPoints& points) {
  for (const AccuracyPoint& point : points.points)
    if (point.id == "scene") return &point;
  return nullptr;
}

/// The view by which a choice is made: what the solving costs where that can be told.
AccuracyPoints choiceOf(const StudyFolder& study, AccuracyQuantity quantity) { return accuracyPoints(study, {AccuracyAgainst::OwnCells, quantity}); }

std::string plain(const QString& words) { return words.toStdString(); }

LogLogPlot plotOf(const AccuracyPoints& points, const QString& scene, double budgetMs, const QString& machine) {
  const AccuracyQuantity quantity = points.view.quantity;
  LogLogPlot plot;
  plot.title = plain(AccuracyTexts::tr("What accuracy costs: %1, %2").arg(quantityName(quantity), scene));
  plot.subtitle = {plain(AccuracyTexts::tr("Error against %1. Lower left is better. Whiskers reach up to 95 of 100 steps; hollow: compared in fewer moments.").arg(againstName(points.view.against))),
                   plain(machine)};
  plot.xTitle = plain(isLengthQuantity(quantity) ? AccuracyTexts::tr("Error of %1, mm").arg(quantityName(quantity)) : AccuracyTexts::tr("Error of %1, N").arg(quantityName(quantity)));
  plot.yTitle = plain(AccuracyTexts::tr("Computing time for each %1 ms that are simulated, ms").arg(QLocale().toString(points.stepMs, 'g', 3)));
  if (std::isfinite(points.floor)) {
    plot.band = points.floor;
    plot.bandLabel = plain(AccuracyTexts::tr("below the reference’s own error: no difference can be told"));
    plot.limit = 2 * points.floor;
    plot.limitLabel = plain(AccuracyTexts::tr("twice that"));
  }
  std::vector<double> levels{1, 5, 20};
  if (std::find(levels.begin(), levels.end(), budgetMs) == levels.end()) levels.push_back(budgetMs);
  for (const double ms : levels) plot.levels.push_back({ms, plain(ms == points.stepMs ? AccuracyTexts::tr("%1 (real time)").arg(msText(ms)) : msText(ms))});
  double least = points.floor > 0 ? points.floor : INFINITY;
  for (const AccuracyPoint& point : points.points)
    if (point.error > 0) least = std::min(least, point.error);
  const auto placeOf = [&](const AccuracyPoint& point) { return point.error == 0 ? (std::isfinite(least) ? 0.5 * least : 1e-3) : point.error; };
  plot.marginTitle = plain(AccuracyTexts::tr("No error to draw"));
  for (std::size_t k = 0; k < points.points.size(); ++k) {
    const AccuracyPoint& point = points.points[k];
    if (!point.failure.empty()) {
      plot.margin.push_back({point.ms, point.id, plain(failureWords(point.failure, point.detail))});
      continue;
    }
    if (!std::isfinite(point.error)) continue;  // has no place in this view: it is a model of other cells
    const std::string family = plain(familyName(point.family));
    auto series = std::find_if(plot.series.begin(), plot.series.end(), [&](const PlotSeries& one) { return one.name == family; });
    if (series == plot.series.end()) series = plot.series.insert(series, PlotSeries{family, {}});
    PlotPoint place{placeOf(point), point.ms, point.id, point.p95};
    place.important = std::find(points.front.begin(), points.front.end(), k) != points.front.end() || point.id == "scene";
    place.hollow = point.few || point.rough;
    series->points.push_back(std::move(place));
  }
  PlotSeries front{plain(AccuracyTexts::tr("no other is both faster and nearer")), {}, true, false};
  for (const std::size_t k : points.front) front.points.push_back({placeOf(points.points[k]), points.points[k].ms});
  plot.series.push_back(std::move(front));
  return plot;
}

/// Which setting for which budget, with all of its errors.
void budgetTable(const StudyFolder& study, double budgetMs, AccuracyAgainst against, Report& report) {
  std::vector<AccuracyPoints> views;
  for (const AccuracyQuantity quantity : kQuantities4) views.push_back(accuracyPoints(study, {against, quantity}));
  if (!measuredIn(views[0])) return;
  ReportTable table;
  table.caption = AccuracyTexts::tr("The setting nearest to the reference by displacement that stays within a budget in 95 of 100 steps; errors against %1.").arg(againstName(against));
  table.columns = {AccuracyTexts::tr("Budget"), AccuracyTexts::tr("Setting"), AccuracyTexts::tr("Median"), AccuracyTexts::tr("95 of 100")};
  for (const AccuracyPoints& view : views) table.columns << capital(quantityName(view.view.quantity));
  table.figures = {0, 2, 3, 4, 5, 6, 7};
  const auto add = [&](const QString& budget, const std::optional<std::size_t>& found) {
    if (!found) {
      table.rows.push_back({budget, AccuracyTexts::tr("none"), QStringLiteral("–"), QStringLiteral("–"), QStringLiteral("–"), QStringLiteral("–"), QStringLiteral("–"), QStringLiteral("–")});
      return;
    }
    const AccuracyPoint& point = views[0].points[*found];
    QStringList row{budget, capital(settingWords(point.id)), msText(point.ms), msText(point.p95)};
    for (const AccuracyPoints& view : views) row << errorText(view.view.quantity, view.points[*found].error);
    table.rows.push_back(row);
  };
  std::vector<double> budgets{1, 5, 20};
  if (std::find(budgets.begin(), budgets.end(), budgetMs) == budgets.end()) budgets.push_back(budgetMs);
  std::sort(budgets.begin(), budgets.end());
  for (const double ms : budgets) add(msText(ms), views[0].pickForBudget(ms));
  for (std::size_t k = 0; k < views[0].points.size(); ++k)
    if (views[0].points[k].id == "scene") add(AccuracyTexts::tr("as it is"), k);
  report.table(std::move(table));
}

void settingsTable(const StudyFolder& study, Report& report) {
  const AccuracyPoints own = choiceOf(study, AccuracyQuantity::Displacement), finer = accuracyPoints(study, {AccuracyAgainst::FinerCells, AccuracyQuantity::Displacement}),
                       force = choiceOf(study, AccuracyQuantity::ContactForce);
  ReportTable table;
  table.caption = AccuracyTexts::tr("All settings by time. Errors of displacement against the same cells in very small steps and against finer cells, and of contact force; those that failed with their reason.");
  table.columns = {AccuracyTexts::tr("Setting"), AccuracyTexts::tr("Median"), AccuracyTexts::tr("95 of 100"), AccuracyTexts::tr("Displacement, same cells"),
                   AccuracyTexts::tr("Displacement, finer cells"), AccuracyTexts::tr("Contact force, same cells"), AccuracyTexts::tr("Remark")};
  table.figures = {1, 2, 3, 4, 5};
  std::vector<std::size_t> order(own.points.size());
  for (std::size_t k = 0; k < order.size(); ++k) order[k] = k;
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) {
    const double x = own.points[a].ms, y = own.points[b].ms;
    return std::isfinite(x) && (!std::isfinite(y) || x < y);
  });
  for (const std::size_t k : order) {
    const AccuracyPoint& point = own.points[k];
    QString remark;
    if (!point.failure.empty()) remark = failureWords(point.failure, point.detail);
    else if (!point.inScenario) remark = AccuracyTexts::tr("no scenario can say it");
    else if (std::find(own.front.begin(), own.front.end(), k) != own.front.end()) remark = AccuracyTexts::tr("no other is both faster and nearer");
    table.rows.push_back({capital(settingWords(point.id)), msText(point.ms), msText(point.p95), errorText(AccuracyQuantity::Displacement, point.error),
                          errorText(AccuracyQuantity::Displacement, finer.points[k].error), errorText(AccuracyQuantity::ContactForce, force.points[k].error), remark});
  }
  report.table(std::move(table));
}

}  // namespace

QString accuracyAnswer(const StudyFolder& study, double budgetMs) {
  const AccuracyPoints points = choiceOf(study, AccuracyQuantity::Displacement);
  const QString scene = sceneOf(study);
  if (!measuredIn(points)) return AccuracyTexts::tr("%1: the study holds no errors to choose by.").arg(scene);
  const auto found = points.pickForBudget(budgetMs);
  if (!found) {
    double least = INFINITY;
    for (const AccuracyPoint& point : points.points)
      if (point.inScenario && point.failure.empty() && std::isfinite(point.p95)) least = std::min(least, point.p95);
    return AccuracyTexts::tr("%1: no setting stays within %2 in 95 of 100 steps; the cheapest takes %3.").arg(scene, msText(budgetMs), msText(least));
  }
  const AccuracyPoint& point = points.points[*found];
  QString words = AccuracyTexts::tr("For %1 of computing to each %2 of simulated time, run %3 with this setting: %4.").arg(msText(budgetMs), msText(points.stepMs), scene, settingWords(point.id));
  words += QLatin1Char(' ') + AccuracyTexts::tr("It costs %1 (median; %2 in 95 of 100 steps) and lies %3 of displacement away from the same scene solved in very small steps.")
                                  .arg(msText(point.ms), msText(point.p95), errorText(AccuracyQuantity::Displacement, point.error));
  if (point.error <= points.floor) words += QLatin1Char(' ') + AccuracyTexts::tr("That is within the reference’s own error, %1: nearer cannot be told.").arg(errorText(AccuracyQuantity::Displacement, points.floor));
  const AccuracyPoint* scene0 = sceneItself(points);
  if (scene0 && scene0->id != point.id)
    words += QLatin1Char(' ') + AccuracyTexts::tr("The scene as it is costs %1 and lies %2 away.").arg(msText(scene0->ms), errorText(AccuracyQuantity::Displacement, scene0->error));
  const AccuracyPoints finer = accuracyPoints(study, {AccuracyAgainst::FinerCells, AccuracyQuantity::Displacement});
  if (measuredIn(finer)) {
    words += QLatin1Char(' ') + AccuracyTexts::tr("What its cells leave out beside that is not a matter of solving: against finer cells it lies %1 away.").arg(errorText(AccuracyQuantity::Displacement, finer.points[*found].error));
    if (const auto other = finer.pickForBudget(budgetMs); other && *other != *found)
      words += QLatin1Char(' ') + AccuracyTexts::tr("Nearest to finer cells within the same time is: %1, at %2 and %3.")
                                      .arg(settingWords(finer.points[*other].id), msText(finer.points[*other].ms), errorText(AccuracyQuantity::Displacement, finer.points[*other].error));
  }
  return words;
}

void reportAccuracy(const StudyFolder& study, double budgetMs, Report& report) {
  const QString scene = sceneOf(study);
  report.heading(2, AccuracyTexts::tr("What accuracy costs: %1").arg(scene));
  report.words(AccuracyTexts::tr("From the same moments of the run, the scene is stepped under many settings. Each is a point: how long it computes, and how far it then lies from a reference "
                                 "that was refined until it hardly moved. The reference’s own error is drawn grey: to the left of it nothing can be told apart."));
  const JsonValue& head = study.head();
  const QString machine = QStringLiteral("%1, %2, %3").arg(QString::fromStdString(head["processor"].text()), QString::fromStdString(head["build"].text()), QString::fromStdString(head["isa"].text()));
  for (const AccuracyAgainst against : {AccuracyAgainst::OwnCells, AccuracyAgainst::FinerCells}) {
    const AccuracyPoints first = accuracyPoints(study, {against, AccuracyQuantity::Displacement});
    if (!first.missing.empty()) {
      report.words(AccuracyTexts::tr("There is no comparison with %1: %2").arg(againstName(against), QString::fromStdString(first.missing)));
      continue;
    }
    budgetTable(study, budgetMs, against, report);
    for (const AccuracyQuantity quantity : kQuantities4) {
      const AccuracyPoints points = accuracyPoints(study, {against, quantity});
      if (!measuredIn(points)) continue;
      report.figure(AccuracyTexts::tr("Computing time over the error of %1, against %2.").arg(quantityName(quantity), againstName(against)), plotOf(points, scene, budgetMs, machine));
    }
  }
  settingsTable(study, report);
}

}  // namespace glenoid
