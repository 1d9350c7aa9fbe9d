// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/BuildJointFile.h"

#include <cstdio>

#include "app/commands/Console.h"
#include "simcore/scene/BuildJoint.h"
#include "simcore/scene/JointFile.h"
#include "simcore/scene/RecipeFile.h"

namespace glenoid {

Result<Done> buildJointFile(const std::string& recipeFile, const std::string& meshes, const std::string& out) {
  const Result<JointRecipe> recipe = loadRecipe(recipeFile, meshes);
  if (!recipe) return recipe.error();
  Result<Joint> joint = Error{};
  {
    ProgressLine progress("Building " + recipe->name);
    joint = buildJoint(*recipe, [&](const std::string&, double done) {
      progress.show(done);
      return true;
    });
  }
  if (!joint) return joint.error();
  if (const auto saved = saveJoint(*joint, out); !saved) return saved.error();
  for (const Part& part : joint->parts) {
    std::printf("%3d  %-24s %6zu visual, %5zu collision", part.number, part.id.c_str(), part.visual->triangles.size(),
                part.collision->triangles.size());
    if (part.volume) std::printf(", %5zu tetrahedra in cells of %.2f mm", part.volume->tets.size(), part.cellSize * 1e3);
    std::putchar('\n');
  }
  std::printf("%s: hash %s\n", out.c_str(), jointHash(*joint).c_str());
  return Done{};
}

}  // namespace glenoid
