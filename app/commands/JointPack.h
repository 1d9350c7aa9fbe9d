// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "simcore/base/Error.h"

namespace glenoid {

/// A joint to begin with in a new folder; says what to do with it. `kind`: one of starterNames. Fails as saveStarter does.
Result<Done> newJoint(const std::string& folder, const std::string& kind);
/// "elbow, knee".
std::string starterNames();

/// A .joint folder (or builtin:NAME) as one .jointz file, and back. Fail as packJoint and unpackJoint do, and with BadUsage for
/// another ending.
Result<Done> packJointFile(const std::string& joint, const std::string& archive);
Result<Done> unpackJointFile(const std::string& archive, const std::string& folder);

}  // namespace glenoid
