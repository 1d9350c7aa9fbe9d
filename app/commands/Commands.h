// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace CLI {
class App;
}

namespace glenoid {

/// Each adds one subcommand. It runs when the line has been read and leaves its exit status in `status`.
void addRunCommand(CLI::App& app, int& status);
void addRenderCommand(CLI::App& app, int& status);
void addJointCommand(CLI::App& app, int& status);
void addMeshCommand(CLI::App& app, int& status);
void addReplayCommand(CLI::App& app, int& status);
void addExportCommand(CLI::App& app, int& status);
void addBenchCommand(CLI::App& app, int& status);
void addDevicesCommand(CLI::App& app, int& status);
void addRecordsCommand(CLI::App& app, int& status);
/// Draws plots, whose letters need a QGuiApplication.
void addStudyCommand(CLI::App& app, int& status);

}  // namespace glenoid
