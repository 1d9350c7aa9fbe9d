// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "editor/core/Document.h"

namespace glenoid {

/// A scene for the window from SCENARIO or JOINT as on the command line, with the recording that ships with it.
Result<Scene> loadScene(const std::string& word);

/// Writes NAME.scenario.json and, beside it, NAME.joint; the scenario refers to that joint.
Result<Done> saveScene(const Scene& scene, const std::string& path);

}  // namespace glenoid
