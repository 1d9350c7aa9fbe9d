// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/import/gltf/GltfExtensions.h"

#include <algorithm>
#include <array>

#include "simcore/file/Json.h"
#include "simcore/import/gltf/GltfFile.h"

namespace glenoid {
namespace {

/// What changes no shape, and what is read: KHR_mesh_quantization and EXT_meshopt_compression by GltfPlain.
constexpr std::array<std::string_view, 10> kHarmless{"KHR_materials_", "KHR_texture_", "EXT_texture_", "MSFT_texture_", "KHR_lights_", "EXT_lights_", "KHR_xmp",
                                                     "KHR_draco_mesh_compression", "KHR_mesh_quantization", "EXT_meshopt_compression"};

}  // namespace

std::vector<std::string> extensionsNotUnderstood(std::string_view bytes, bool binary) {
  std::vector<std::string> unknown;
  const auto json = parseJson(gltfText(bytes, binary), "");
  if (!json) return unknown;
  for (const JsonValue& each : (*json)["extensionsRequired"].items()) {
    const std::string& name = each.text();
    if (name.empty() || std::any_of(kHarmless.begin(), kHarmless.end(), [&](std::string_view start) { return name.starts_with(start); })) continue;
    unknown.push_back(name.substr(0, 60));
  }
  return unknown;
}

}  // namespace glenoid
