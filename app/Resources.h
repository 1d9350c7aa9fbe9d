// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

namespace glenoid {

/// Folder of what ships with the program (joints, scenarios, recordings, schemas): the environment's
/// GLENOID_RESOURCES, else ../share/glenoid beside the installed program, else the sources it was built from.
const std::string& resourceRoot();

/// Whether the word of the command line names a joint rather than a scenario: a built-in joint of that name, a
/// folder, its joint.json, or something that ends in ".joint" or ".jointz".
bool namesJoint(const std::string& word);

}  // namespace glenoid
