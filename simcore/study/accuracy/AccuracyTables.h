// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/study/StudyTable.h"
#include "simcore/study/accuracy/AccuracyPick.h"

namespace glenoid {

/// "settings": a row for each setting, failed ones with their reason. "references": both, with their own errors. "windows": the
/// states, with their hashes. Lengths in mm, forces in N; a column of errors ends in OwnCells or FinerCells after what it is compared with.
std::vector<StudyTable> accuracyTables(const AccuracyResult& result);

}  // namespace glenoid
