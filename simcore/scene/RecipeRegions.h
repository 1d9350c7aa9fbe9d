// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "simcore/base/Error.h"
#include "simcore/file/JsonValue.h"
#include "simcore/scene/Recipe.h"

namespace glenoid {

/// Fills the regions of a recipe's parts that say by what they are found instead of listing triangles: all surface within a distance
/// of another part, in a ball, and regions of the same part that stand before them, united, in common, or one less others. All
/// surfaces must be loaded; `parts` are the recipe's, in the order of its file. Fails with UnknownId (arguments: id, kind) and Unusable (nothing is
/// left); the place names the region.
Result<Done> fillRegions(std::vector<PartRecipe>& parts, const JsonValue& json, const std::string& file);

}  // namespace glenoid
