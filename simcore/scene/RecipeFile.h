// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "simcore/base/Error.h"
#include "simcore/scene/Recipe.h"
#include "simcore/scene/RecipeSource.h"

namespace glenoid {

/// Reads a recipe (RECIPE.json, see recipe.schema.json) and the surfaces it names, files inside `meshes`: PLY in metres,
/// or whatever can be imported, placed and repaired as their "source" says (RecipeSource.h); `reports` then tells what
/// was done to them. Fails as readDocument and RecipeSurfaces do and with DuplicateId, UnknownId or BadReference (a mesh
/// name that leaves the folder). A soft part names tetrahedra or cellSize, a rigid one neither (Unusable).
Result<JointRecipe> loadRecipe(const std::string& path, const std::string& meshes,
                               std::vector<SourceReport>* reports = nullptr);

}  // namespace glenoid
