// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace CLI {
class App;
}

namespace glenoid {

/// Each adds one study to `glenoid study`.
void addAccuracyStudy(CLI::App& study, int& status);
void addEffectsStudy(CLI::App& study, int& status);
void addStabilityStudy(CLI::App& study, int& status);
/// What they found, as one document.
void addStudyReport(CLI::App& study, int& status);
void addTruthStudy(CLI::App& study, int& status);

}  // namespace glenoid
