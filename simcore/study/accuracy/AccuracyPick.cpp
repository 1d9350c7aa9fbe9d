// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/accuracy/AccuracyPick.h"

#include <algorithm>
#include <cmath>

namespace glenoid {
namespace {

bool inAllWindows(const AccuracyResult& result, const AccuracyRow& row) { return row.windows == static_cast<int>(result.windows.size()); }

double floorOf(const AccuracyResult& result, const AccuracyView& view) { return result.reference(view.against).floor[view.quantity].value; }

/// The references touch by the scene's own collision surfaces: what lies between those and the visual ones is a difference of two models,
/// and no error of the finer one.
bool isComparable(const AccuracyResult& result, const AccuracyRow& row, const AccuracyView& view) {
  return errorIn(row, view) && inAllWindows(result, row) && !row.setting.visualContact && row.timed > 0;
}

bool mayBePicked(const AccuracyResult& result, const AccuracyRow& row, const AccuracyView& view) {
  return isComparable(result, row, view) && fitsScenario(row.setting);
}

/// The row for which `better(a, b)` holds against all others; of equals the first.
template <class Fits, class Better>
std::optional<std::size_t> best(const AccuracyResult& result, const Fits& fits, const Better& better) {
  std::optional<std::size_t> found;
  for (std::size_t k = 0; k < result.rows.size(); ++k)
    if (fits(result.rows[k]) && (!found || better(result.rows[k], result.rows[*found]))) found = k;
  return found;
}

}  // namespace

std::optional<double> errorIn(const AccuracyRow& row, const AccuracyView& view) {
  const auto& errors = row.errors[static_cast<std::size_t>(view.against)];
  if (!row.failure.reason.empty() || !errors || !std::isfinite((*errors)[view.quantity].value)) return std::nullopt;
  return (*errors)[view.quantity].value;
}

std::vector<std::size_t> paretoFront(const AccuracyResult& result, const AccuracyView& view) {
  std::vector<std::size_t> order, front;
  for (std::size_t k = 0; k < result.rows.size(); ++k)
    if (isComparable(result, result.rows[k], view)) order.push_back(k);
  const auto at = [&](std::size_t k) { return std::pair(result.rows[k].work.median, *errorIn(result.rows[k], view)); };
  std::stable_sort(order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return at(a) < at(b); });
  for (const std::size_t k : order)
    if (front.empty() || at(k).second < at(front.back()).second) front.push_back(k);
  return front;
}

std::optional<std::size_t> pickForBudget(const AccuracyResult& result, const AccuracyView& view, double budgetMs) {
  const double floor = floorOf(result, view);
  const auto known = [&](const AccuracyRow& row) { return std::max(floor, *errorIn(row, view)); };
  return best(
      result, [&](const AccuracyRow& row) { return mayBePicked(result, row, view) && row.work.p95 <= budgetMs; },
      [&](const AccuracyRow& a, const AccuracyRow& b) { return std::pair(known(a), a.work.median) < std::pair(known(b), b.work.median); });
}

std::optional<std::size_t> pickForAccuracy(const AccuracyResult& result, const AccuracyView& view, double error) {
  return best(
      result, [&](const AccuracyRow& row) { return mayBePicked(result, row, view) && *errorIn(row, view) <= error; },
      [&](const AccuracyRow& a, const AccuracyRow& b) { return a.work.median < b.work.median; });
}

double leastAccuracy(const AccuracyResult& result, const AccuracyView& view) { return 2 * floorOf(result, view); }

}  // namespace glenoid
