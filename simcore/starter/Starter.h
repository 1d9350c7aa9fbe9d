// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <span>
#include <string>
#include <vector>

#include "simcore/base/Error.h"
#include "simcore/mesh/TriMesh.h"

/// Small joints to begin with: bones and ligaments from formulas, a recipe, a scenario and a README that an author edits. The
/// texts lie in resources/starters, the surfaces are made here. Right side; W: X forward, Y up, Z to the right, origin on the
/// axis of the hinge.
namespace glenoid {

/// A surface as another program would hand it over: closed, millimetres, frame W.
struct StarterSurface {
  std::string name;  ///< of its file, without ending
  TriMesh mesh;
};

/// A joint to begin with. `name` is its word on the command line, its folder in resources/starters and its id.
struct StarterKind {
  const char* name;
  std::vector<StarterSurface> (*surfaces)();  ///< some seconds; the same each time
};

/// All of them; the first is the one that an author gets who names none.
std::span<const StarterKind> starterKinds();
/// Null when there is none of that name.
const StarterKind* findStarter(const std::string& name);

/// Files of a starter in a folder.
struct StarterFiles {
  std::string recipe, meshes, joint, scenario;  ///< paths; `joint` is where the recipe's joint is expected, and not there yet
};

/// Writes recipe.json, NAME.scenario.json, README.md and meshes/*.stl (millimetres) into `folder`, which is made when its parent
/// is there. Fails with FileUnwritable when something lies in the folder already, and as writeWholeFile and readWholeFile do
/// (`resources`: the folder of what ships).
Result<StarterFiles> saveStarter(const StarterKind& kind, const std::string& resources, const std::string& folder);

/// Surfaces of each kind.
std::vector<StarterSurface> elbowSurfaces();
std::vector<StarterSurface> kneeSurfaces();

}  // namespace glenoid
