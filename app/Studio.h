// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

class QApplication;

namespace glenoid {

/// What the studio is asked to do when it starts.
struct StudioOptions {
  std::string file;     ///< scenario, joint or builtin:NAME; empty: the built-in arthroscopy
  std::string records;  ///< where trainings are kept, as RecordStore::open; empty: the user's own file
};

/// Shows the window and runs until it is closed; answers the exit status. The application must have been made
/// after prepareGraphics().
int runStudio(QApplication& application, const StudioOptions& options);

/// The same, with an application of its own. Where no display can be reached it says so and answers 2.
int runStudio(int argc, char** argv, const StudioOptions& options);

}  // namespace glenoid
