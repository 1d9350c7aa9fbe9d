// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "editor/lab/StudyFolder.h"
#include "simcore/study/accuracy/AccuracyPick.h"

namespace glenoid {

/// One setting of a study in one view of it; NaN where nothing is known. Errors in mm or N, as shown.
struct AccuracyPoint {
  std::string id, family;
  double error = std::numeric_limits<double>::quiet_NaN(), most = std::numeric_limits<double>::quiet_NaN();
  std::string where;          ///< part, pair or tool for which it is largest
  double ms = std::numeric_limits<double>::quiet_NaN(), p95 = std::numeric_limits<double>::quiet_NaN();  ///< of work
  bool rough = false;         ///< ms is a guess made before times were taken
  bool few = false;           ///< compared in fewer windows than others
  bool inScenario = false;    ///< a scenario can say it
  bool otherSurfaces = false; ///< touches by its visual surfaces: another model than the references
  std::string failure, detail;  ///< why it has no error: "not-built", "not-finite", "diverged"; empty: it has one
};

/// What a study says in one view, by the rules of simcore/study/accuracy/AccuracyPick.h, from its rows.
struct AccuracyPoints {
  AccuracyView view;
  std::vector<AccuracyPoint> points;
  double floor = std::numeric_limits<double>::quiet_NaN();  ///< the reference's own error, mm or N; NaN: not known yet
  std::string missing;                                      ///< why there is no reference
  double stepMs = 5;                                        ///< of the scene: simulated for each `ms`
  std::vector<std::size_t> front;                           ///< no other is both faster and nearer; by ms

  std::optional<std::size_t> pickForBudget(double budgetMs) const;
  /// Not to be asked below twice the floor.
  std::optional<std::size_t> pickForAccuracy(double error) const;
};

AccuracyPoints accuracyPoints(const StudyFolder& study, const AccuracyView& view);

/// Displacement and penetration are lengths, shown in mm; the others forces in N.
constexpr bool isLengthQuantity(AccuracyQuantity quantity) { return quantity == AccuracyQuantity::Displacement || quantity == AccuracyQuantity::Penetration; }

}  // namespace glenoid
