// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <filesystem>
#include <string>

namespace glenoid::testing {

/// What a run of the program left behind.
struct Outcome {
  int status = -1;  ///< exit status; −1 when it was killed
  std::string out, err;
};

/// Runs `glenoid ARGUMENTS` through the shell, without a display and without standard input.
Outcome glenoidProgram(const std::string& arguments);

/// Lines of a text, counting a last one without line break.
int lineCount(const std::string& text);

/// The whole file; empty when it is not there.
std::string readText(const std::filesystem::path& path);
void writeText(const std::filesystem::path& path, const std::string& text);

/// An empty folder of its own for the test that runs; below the build folder, so that a failure can be looked at.
std::filesystem::path freshFolder();

}  // namespace glenoid::testing
