// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "editor/core/Document.h"
#include "editor/lab/LabServices.h"

namespace glenoid {

/// A scene for the window from SCENARIO or JOINT as on the command line, with the recording that ships with it.
Result<Scene> loadScene(const std::string& word);

/// A joint to begin with, built in a new folder; answers its scenario's path. `goOn` gets how much is done, 0…1, and ends it when it
/// answers false. Fails as saveStarter, loadRecipe, buildJoint and saveJoint do.
Result<std::string> startScene(const std::string& kind, const std::string& folder, const std::function<bool(double)>& goOn);

/// Writes NAME.scenario.json and, beside it, NAME.joint; the scenario refers to that joint.
Result<Done> saveScene(const Scene& scene, const std::string& path);

/// What the lab asks for. `program`: glenoid itself, which runs studies.
LabServices labServices(const QString& program);

}  // namespace glenoid
