// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "simcore/base/Error.h"
#include "simcore/scene/Recipe.h"

namespace glenoid {

/// Reads a recipe (RECIPE.json, see recipe.schema.json) and the surfaces it names, PLY files inside `meshes`.
/// Fails as readDocument and readPly do and with DuplicateId, UnknownId or BadReference (a mesh name that leaves the
/// folder). A soft part names tetrahedra or cellSize, a rigid one neither (Unusable).
Result<JointRecipe> loadRecipe(const std::string& path, const std::string& meshes);

}  // namespace glenoid
