// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/accuracy/AccuracyTables.h"

#include <algorithm>

namespace glenoid {
namespace {

using Rows = std::vector<StudyCell>;
constexpr const char* kSuffix[kAccuracyReferences] = {"FinerCells", "OwnCells"};

bool isLength(AccuracyQuantity quantity) { return quantity == AccuracyQuantity::Displacement || quantity == AccuracyQuantity::Penetration; }

/// In millimetres or newtons.
double shown(AccuracyQuantity quantity, double value) { return isLength(quantity) ? 1e3 * value : value; }

std::string columnOf(AccuracyQuantity quantity, const std::string& kind, const char* suffix) {
  return std::string(quantityKey(quantity)) + kind + suffix + (isLength(quantity) ? "Mm" : "N");
}

bool measured(const AccuracyResult& result, AccuracyQuantity quantity) { return quantity != AccuracyQuantity::HandForce || result.hands; }

void appendErrors(const AccuracyResult& result, const std::optional<AccuracyErrors>& errors, Rows& row) {
  for (int q = 0; q < kAccuracyQuantities; ++q) {
    const auto quantity = static_cast<AccuracyQuantity>(q);
    if (!errors || !measured(result, quantity)) {
      row.insert(row.end(), 3, StudyCell());
      continue;
    }
    const AccuracyError& error = (*errors)[quantity];
    row.insert(row.end(), {shown(quantity, error.value), shown(quantity, error.most), error.where});
  }
}

void appendColumns(const char* suffix, std::vector<std::string>& columns) {
  for (int q = 0; q < kAccuracyQuantities; ++q) {
    const auto quantity = static_cast<AccuracyQuantity>(q);
    columns.push_back(columnOf(quantity, "", suffix));
    columns.push_back(columnOf(quantity, "Most", suffix));
    columns.push_back(std::string(quantityKey(quantity)) + "Where" + suffix);
  }
}

StudyTable settingsTable(const AccuracyResult& result) {
  StudyTable table;
  table.id = "settings";
  table.columns = {"setting", "family", "failure", "failureDetail", "inScenario", "profile", "dtMs", "cells", "elements", "contactSurfaces",
                   "tetrahedra", "windows", "steps", "stepMedianMs", "stepP95Ms", "stepP99Ms", "wallMedianMs", "wallP95Ms", "stepsTimed",
                   "workMedianMs", "workP95Ms", "workP99Ms"};
  for (const char* suffix : {kSuffix[1], kSuffix[0]}) appendColumns(suffix, table.columns);
  for (const char* name : {"contactsMean", "deepestMm", "deepestWhere", "cappedSteps", "unsolvedIslands"}) table.columns.emplace_back(name);
  for (const char* name : {"frontOwnCells", "frontFinerCells", "machine"}) table.columns.emplace_back(name);
  std::array<std::vector<std::size_t>, kAccuracyReferences> fronts;
  for (std::size_t r = 0; r < fronts.size(); ++r) fronts[r] = paretoFront(result, {static_cast<AccuracyAgainst>(r), AccuracyQuantity::Displacement});
  for (std::size_t k = 0; k < result.rows.size(); ++k) {
    const AccuracyRow& row = result.rows[k];
    const AccuracySetting& setting = row.setting;
    std::string detail;
    if (row.failure.reason == "not-built") detail = toLogLine(row.failure.error);
    else if (!row.failure.reason.empty()) detail = std::to_string(row.failure.count) + " of " + std::to_string(row.failure.of) + " steps";
    Rows cells{setting.id, setting.family, row.failure.reason, detail, fitsScenario(setting), std::string(profileName(setting.profile)), 1e3 * setting.dt,
               setting.cells, std::string(!setting.elements ? "own" : *setting.elements == Elements::Cells ? "cells" : "tetrahedra"),
               std::string(setting.visualContact ? "visual" : "collision"), row.tetrahedra, long{row.windows}, row.steps};
    const Rows times{row.cpu.median, row.cpu.p95, row.cpu.p99, row.wall.median, row.wall.p95, row.timed, row.work.median, row.work.p95, row.work.p99};
    if (row.timed > 0) cells.insert(cells.end(), times.begin(), times.end());
    else cells.insert(cells.end(), times.size(), StudyCell());
    for (const std::size_t r : {1, 0}) appendErrors(result, row.errors[r], cells);
    if (row.windows > 0) {
      const Rows rest{row.contacts, 1e3 * row.deepest, row.deepestWhere, row.cappedSteps, row.unsolvedIslands};
      cells.insert(cells.end(), rest.begin(), rest.end());
    } else {
      cells.insert(cells.end(), 5, StudyCell());
    }
    for (const std::size_t r : {1, 0}) cells.emplace_back(std::find(fronts[r].begin(), fronts[r].end(), k) != fronts[r].end());
    cells.emplace_back(row.machine);
    table.rows.push_back(std::move(cells));
  }
  return table;
}

StudyTable referencesTable(const AccuracyResult& result) {
  StudyTable table;
  table.id = "references";
  table.columns = {"against", "missing", "finest", "coarser", "tetrahedra"};
  appendColumns("Floor", table.columns);
  appendColumns("SolverCheck", table.columns);
  for (const std::size_t r : {1, 0}) {
    const AccuracyReference& reference = result.references[r];
    Rows row{std::string(againstKey(static_cast<AccuracyAgainst>(r))), reference.missing ? toLogLine(*reference.missing) : std::string(), reference.finest.id,
             reference.coarser.id, reference.tetrahedra};
    appendErrors(result, reference.missing ? std::nullopt : std::optional(reference.floor), row);
    appendErrors(result, reference.check, row);
    table.rows.push_back(std::move(row));
  }
  return table;
}

StudyTable windowsTable(const AccuracyResult& result) {
  StudyTable table;
  table.id = "windows";
  table.facts = {{"lengthS", result.wishes.seconds}, {"samplesEveryS", result.wishes.grid}};
  table.columns = {"timeS", "chosenFor", "mark", "speedMPerS", "forceN", "stateHash"};
  for (const AccuracyWindow& window : result.windows)
    table.rows.push_back({window.time, std::string(window.loaded ? "load" : "motion"), window.mark, window.speed, window.force, window.stateHash});
  return table;
}

}  // namespace

std::vector<StudyTable> accuracyTables(const AccuracyResult& result) { return {settingsTable(result), referencesTable(result), windowsTable(result)}; }

}  // namespace glenoid
