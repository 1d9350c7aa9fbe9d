// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/import/GltfExtensions.h"

#include <algorithm>
#include <array>
#include <cstring>

#include "simcore/file/Json.h"

namespace glenoid {
namespace {

constexpr std::array<std::string_view, 8> kHarmless{"KHR_materials_", "KHR_texture_", "EXT_texture_", "MSFT_texture_",
                                                    "KHR_lights_",    "EXT_lights_",  "KHR_xmp",      "KHR_draco_mesh_compression"};

/// The first chunk of a GLB: 12 bytes of header, then length, “JSON” and the text.
std::string_view textOf(std::string_view bytes, bool binary) {
  if (!binary) return bytes;
  std::uint32_t length = 0;
  if (bytes.size() < 20 || bytes.substr(16, 4) != "JSON") return {};
  std::memcpy(&length, bytes.data() + 12, 4);
  return bytes.substr(20, length);
}

}  // namespace

std::vector<std::string> extensionsNotUnderstood(std::string_view bytes, bool binary) {
  std::vector<std::string> unknown;
  const auto json = parseJson(textOf(bytes, binary), "");
  if (!json) return unknown;
  for (const JsonValue& each : (*json)["extensionsRequired"].items()) {
    const std::string& name = each.text();
    if (name.empty() || std::any_of(kHarmless.begin(), kHarmless.end(), [&](std::string_view start) { return name.starts_with(start); })) continue;
    unknown.push_back(name.substr(0, 60));
  }
  return unknown;
}

}  // namespace glenoid
