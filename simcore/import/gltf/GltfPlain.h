// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>
#include <string_view>

#include "simcore/base/Error.h"

namespace glenoid {

/// A glTF written anew so that the reader behind understands it; its other buffers stay where they are.
struct PlainGltf {
  std::string bytes;   ///< in the form of the file, text or GLB
  std::string beside;  ///< what the buffer named by `kBesideName` holds
  long skins = 0;      ///< surfaces that were placed by their joints
  long lost = 0;       ///< joints and shapes to blend that went with it
};

/// Turns into plain floats what assimp takes for rubbish or does not do: views packed by EXT_meshopt_compression, values that
/// are integers (KHR_mesh_quantization), and surfaces with a skin, which stand where their joints at rest put them, whatever
/// their own node says (glTF 2.0, 3.7.3.3). Nothing for a file that has none of these, which is nearly every one.
/// Fails as GltfFile does.
Result<std::optional<PlainGltf>> plainGltf(std::string_view bytes, const std::string& path, bool binary);

}  // namespace glenoid
