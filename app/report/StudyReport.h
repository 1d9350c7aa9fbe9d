// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "app/report/Report.h"
#include "editor/lab/StudyFolder.h"

namespace glenoid {

/// What studies found, for a reader who was not there: first in words which setting to use for `budgetMs` and what it costs, then on what
/// machine, then each study with its figures and tables. What has no figure stands as "–".
Report studyReport(const std::vector<StudyFolder>& studies, double budgetMs);

/// Sections of one study each; studies of a kind that is not known are shown by their tables and pictures as they are.
void reportAccuracy(const StudyFolder& study, double budgetMs, Report& report);
void reportStability(const StudyFolder& study, Report& report);
void reportTables(const StudyFolder& study, Report& report);

/// Which setting to use for a budget and what it costs, in sentences; for the beginning.
QString accuracyAnswer(const StudyFolder& study, double budgetMs);

/// The scene that a study is of, as people call it.
QString sceneOf(const StudyFolder& study);

}  // namespace glenoid
