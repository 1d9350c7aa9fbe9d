// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "app/plot/LogLogPlot.h"
#include "simcore/study/accuracy/AccuracyPick.h"

namespace glenoid {

/// What the person asked to be chosen.
struct AccuracyWish {
  AccuracyView view;
  std::optional<double> budgetMs;   ///< --budget
  std::optional<double> accuracy;   ///< --accuracy, m or N as the view's quantity
};

/// "displacement", "contact force", "penetration", "force on the hand".
std::string quantityWords(AccuracyQuantity quantity);
/// 0.0005 m → "0.5 mm"; 2 N → "2 N". Three digits.
std::string quantityText(AccuracyQuantity quantity, double value);

/// Fails with OutOfRange where less is asked than twice the reference's own error, with CheckFailed where no setting will do; the
/// sentence says how near the best one comes. Fails with Unusable where the reference is missing. Nothing was asked: nothing is chosen.
Result<std::optional<std::size_t>> chosenSetting(const AccuracyResult& result, const AccuracyWish& wish);

/// What a person reads: scene, references, the front, and what was chosen.
std::string accuracySummary(const AccuracyResult& result, const std::string& scene, const AccuracyView& view, std::optional<std::size_t> chosen);

/// Work over error in one view. Settings that failed stand at the right margin with their reason.
LogLogPlot accuracyPlot(const AccuracyResult& result, const std::string& scene, const AccuracyView& view, std::optional<std::size_t> chosen,
                        const std::string& machine);

}  // namespace glenoid
