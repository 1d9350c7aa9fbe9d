// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <utility>
#include <variant>
#include <vector>

namespace glenoid {

/// One value of a table; nothing where a row has no figure. Names of columns carry the unit (stepMedianMs).
using StudyCell = std::variant<std::monostate, bool, long, double, std::string>;

/// What a study found: keys and values, no sentence and no layout. Whoever shows it turns keys into words.
struct StudyTable {
  std::string id;
  std::vector<std::pair<std::string, StudyCell>> facts;  ///< true of the whole table
  std::vector<std::string> columns;
  std::vector<std::vector<StudyCell>> rows;              ///< each as long as `columns`
};

}  // namespace glenoid
