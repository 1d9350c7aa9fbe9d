// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <filesystem>
#include <string>

/// Joints and recipes that nobody should have made, from a number: the same number gives the same files.
namespace glenoid::testing {

/// Writes a .joint folder (joint.json and meshes) that is wrong or extreme in one to three ways, and answers what was done.
std::string writeDegenerateJoint(unsigned seed, const std::filesystem::path& folder);

/// The same of a recipe.json with its surfaces in meshes/.
std::string writeDegenerateRecipe(unsigned seed, const std::filesystem::path& folder);

}  // namespace glenoid::testing
