// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "simcore/base/Error.h"

namespace glenoid {

/// The author's pipeline without the window: reads the recipe and the surfaces it names below `meshes` (empty:
/// the folder “meshes” beside the recipe), derives
/// collision surfaces, cells and bindings, and writes the joint. Says on stdout what came of each part.
Result<Done> buildJointFile(const std::string& recipe, const std::string& meshes, const std::string& out);

}  // namespace glenoid
