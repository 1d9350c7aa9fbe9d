// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/StudyCommand.h"

#include <CLI/CLI.hpp>

#include "app/commands/Commands.h"

namespace glenoid {

void addStudyCommand(CLI::App& app, int& status) {
  CLI::App* study = app.add_subcommand("study", "Put a scene to the test and write what came of it");
  study->require_subcommand(1);
  addAccuracyStudy(*study, status);
  addStabilityStudy(*study, status);
  addEffectsStudy(*study, status);
  addStudyReport(*study, status);
  addTruthStudy(*study, status);
}

}  // namespace glenoid
