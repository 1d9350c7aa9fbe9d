// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/lab/AccuracyPoints.h"

#include <algorithm>
#include <cmath>

namespace glenoid {
namespace {

/// As simcore/study/accuracy/AccuracyTables.h names its columns.
std::string columnOf(const AccuracyView& view, const std::string& kind, bool unit) {
  return std::string(quantityKey(view.quantity)) + kind + (view.against == AccuracyAgainst::OwnCells ? "OwnCells" : "FinerCells") +
         (!unit ? "" : isLengthQuantity(view.quantity) ? "Mm" : "N");
}

bool isComparable(const AccuracyPoint& point) {
  return point.failure.empty() && std::isfinite(point.error) && std::isfinite(point.ms) && !point.rough && !point.few && !point.otherSurfaces;
}

/// Best of those that may be picked; of equals the first.
template <class Fits, class Key>
std::optional<std::size_t> best(const std::vector<AccuracyPoint>& points, const Fits& fits, const Key& key) {
  std::optional<std::size_t> found;
  for (std::size_t k = 0; k < points.size(); ++k)
    if (isComparable(points[k]) && points[k].inScenario && fits(points[k]) && (!found || key(points[k]) < key(points[*found]))) found = k;
  return found;
}

}  // namespace

AccuracyPoints accuracyPoints(const StudyFolder& study, const AccuracyView& view) {
  AccuracyPoints out;
  out.view = view;
  const JsonValue& head = study.head();
  out.stepMs = head["dtMs"].isNumber() ? head["dtMs"].number() : head["dt"].isNumber() ? 1e3 * head["dt"].number() : 5;
  for (const JsonValue& row : study.rows("references"))
    if (row["against"].text() == againstKey(view.against)) {
      out.missing = row["missing"].text();
      const std::string floor = std::string(quantityKey(view.quantity)) + "Floor" + (isLengthQuantity(view.quantity) ? "Mm" : "N");
      if (out.missing.empty()) out.floor = figureOf(row, floor);
    }
  std::int64_t windows = 0;
  for (const JsonValue& row : study.rows("settings")) windows = std::max(windows, row["windows"].integer());
  for (const JsonValue& row : study.rows("settings")) {
    AccuracyPoint& point = out.points.emplace_back();
    point.id = row["setting"].text();
    point.family = row["family"].text();
    point.failure = row["failure"].text();
    point.detail = row["failureDetail"].text();
    point.inScenario = row["inScenario"].boolean();
    point.otherSurfaces = row["contactSurfaces"].text() == "visual";
    point.few = row["windows"].integer() < windows;
    point.ms = figureOf(row, "workMedianMs");
    point.p95 = figureOf(row, "workP95Ms");
    if (!std::isfinite(point.ms) && figureOf(row, "roughWorkMs") > 0) {
      point.ms = figureOf(row, "roughWorkMs");
      point.rough = true;
    }
    if (!point.failure.empty()) continue;
    point.error = figureOf(row, columnOf(view, "", true));
    point.most = figureOf(row, columnOf(view, "Most", true));
    point.where = row[columnOf(view, "Where", false)].text();
  }
  std::vector<std::size_t> order;
  for (std::size_t k = 0; k < out.points.size(); ++k)
    if (isComparable(out.points[k])) order.push_back(k);
  const auto at = [&](std::size_t k) { return std::pair(out.points[k].ms, out.points[k].error); };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return at(a) < at(b); });
  for (const std::size_t k : order)
    if (out.front.empty() || at(k).second < at(out.front.back()).second) out.front.push_back(k);
  return out;
}

std::optional<std::size_t> AccuracyPoints::pickForBudget(double budgetMs) const {
  const double least = std::isfinite(floor) ? floor : 0;
  return best(points, [&](const AccuracyPoint& point) { return point.p95 <= budgetMs; },
              [&](const AccuracyPoint& point) { return std::pair(std::max(least, point.error), point.ms); });
}

std::optional<std::size_t> AccuracyPoints::pickForAccuracy(double error) const {
  return best(points, [&](const AccuracyPoint& point) { return point.error <= error; }, [&](const AccuracyPoint& point) { return point.ms; });
}

}  // namespace glenoid
