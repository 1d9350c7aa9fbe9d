// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/study/accuracy/AccuracyStudy.h"

namespace glenoid {

/// By what a choice is made.
struct AccuracyView {
  AccuracyAgainst against = AccuracyAgainst::OwnCells;
  AccuracyQuantity quantity = AccuracyQuantity::Displacement;
};

/// Error of a row, or nothing where the study has none for this view: it failed, or was not compared with this reference.
std::optional<double> errorIn(const AccuracyRow& row, const AccuracyView& view);

/// Rows that no other beats in both work (median) and error, by work. Only those compared in all windows take part, and none whose visual
/// surfaces touch: they are another model than the references.
std::vector<std::size_t> paretoFront(const AccuracyResult& result, const AccuracyView& view);

/// The most accurate setting that a scenario can say and whose p95 of work fits, ms: work is for as much simulated time as one of
/// the scene's own steps. Errors below the reference's own count as equal, and of equals the faster is taken. Nothing where none fits.
std::optional<std::size_t> pickForBudget(const AccuracyResult& result, const AccuracyView& view, double budgetMs);

/// The fastest (median of work) that a scenario can say and whose error is no more than asked, m or N. Nothing where none is that accurate. Not to be
/// asked below leastAccuracy().
std::optional<std::size_t> pickForAccuracy(const AccuracyResult& result, const AccuracyView& view, double error);

/// Twice the reference's own error: what is asked must be at least this.
double leastAccuracy(const AccuracyResult& result, const AccuracyView& view);

}  // namespace glenoid
