// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace glenoid {

/// Formats of surfaces that can be read.
enum class MeshFormat { Obj, Stl, Ply, Gltf, Glb, ThreeMf, Dae, Fbx, Vtp, Vtu, VtkLegacy };

/// "OBJ", "STL" …
const char* formatName(MeshFormat format);

/// Endings that are accepted, lower case, without dot; what a file dialog offers.
const std::vector<std::string>& importEndings();

/// The format an ending stands for ("surface.STL" → STL); nothing for all others, also where assimp would take
/// them: `.mesh` and `.scn` mean something else to the people who use this program.
std::optional<MeshFormat> formatByEnding(const std::string& path);

/// The format that the content shows, where its first bytes do.
std::optional<MeshFormat> formatByContent(std::string_view bytes);

}  // namespace glenoid
