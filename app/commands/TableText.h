// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "simcore/file/Json.h"
#include "simcore/study/StudyTable.h"

namespace glenoid {

/// A table as a person reads it on the terminal: title, facts, columns under each other. Words and units come from the
/// keys (stepMedianMs: "step median, ms").
std::string tableText(const StudyTable& table, const std::string& title);

/// {"id", "facts": {…}, "columns": […], "rows": [{…}]}: each row an object by column, null where it has no figure.
JsonValue tableJson(const StudyTable& table);

/// "stepMedianMs" → "step median, ms".
std::string keyWords(const std::string& key);

}  // namespace glenoid
