// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "simcore/base/Error.h"

namespace glenoid {

/// `joint mirror`: writes the mirror image of a joint, or of a scenario with its joint and recording, and says what it did.
/// `out` is NAME.joint for a joint and NAME.scenario.json for a scenario, beside which NAME.joint and NAME.recording come to
/// lie. Fails with BadUsage where the two do not fit or the input is a recipe, and as loading and saving do.
Result<Done> mirrorFile(const std::string& word, const std::string& out);

}  // namespace glenoid
