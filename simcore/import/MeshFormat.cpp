// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/import/MeshFormat.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <cstring>

namespace glenoid {
namespace {

struct Row {
  MeshFormat format;
  const char *name, *ending;
};

constexpr std::array<Row, 11> kRows{{{MeshFormat::Obj, "OBJ", "obj"},
                                     {MeshFormat::Stl, "STL", "stl"},
                                     {MeshFormat::Ply, "PLY", "ply"},
                                     {MeshFormat::Gltf, "glTF", "gltf"},
                                     {MeshFormat::Glb, "GLB", "glb"},
                                     {MeshFormat::ThreeMf, "3MF", "3mf"},
                                     {MeshFormat::Dae, "DAE", "dae"},
                                     {MeshFormat::Fbx, "FBX", "fbx"},
                                     {MeshFormat::Vtp, "VTP", "vtp"},
                                     {MeshFormat::Vtu, "VTU", "vtu"},
                                     {MeshFormat::VtkLegacy, "VTK", "vtk"}}};

bool begins(std::string_view text, std::string_view with) { return text.substr(0, with.size()) == with; }

std::string_view trimmed(std::string_view text) {
  if (begins(text, "\xef\xbb\xbf")) text.remove_prefix(3);
  while (!text.empty() && std::isspace(static_cast<unsigned char>(text.front()))) text.remove_prefix(1);
  return text;
}

/// A binary STL says its size: 80 bytes of anything, a count, and 50 bytes for each triangle.
bool isBinaryStl(std::string_view bytes) {
  if (bytes.size() < 84) return false;
  std::uint32_t count = 0;
  std::memcpy(&count, bytes.data() + 80, 4);
  return count > 0 && bytes.size() == 84 + 50 * static_cast<std::uint64_t>(count);
}

}  // namespace

const char* formatName(MeshFormat format) {
  for (const Row& row : kRows)
    if (row.format == format) return row.name;
  return "";
}

const std::vector<std::string>& importEndings() {
  static const std::vector<std::string> endings = [] {
    std::vector<std::string> list;
    for (const Row& row : kRows) list.push_back(row.ending);
    return list;
  }();
  return endings;
}

std::optional<MeshFormat> formatByEnding(const std::string& path) {
  const std::size_t dot = path.rfind('.'), slash = path.rfind('/');
  if (dot == std::string::npos || (slash != std::string::npos && dot < slash)) return std::nullopt;
  std::string ending = path.substr(dot + 1);
  for (char& c : ending) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  for (const Row& row : kRows)
    if (ending == row.ending) return row.format;
  return std::nullopt;
}

std::optional<MeshFormat> formatByContent(std::string_view bytes) {
  if (isBinaryStl(bytes)) return MeshFormat::Stl;
  if (begins(bytes, "glTF")) return MeshFormat::Glb;
  if (begins(bytes, "PK\x03\x04")) return MeshFormat::ThreeMf;
  if (begins(bytes, "Kaydara FBX Binary") || begins(bytes, "; FBX")) return MeshFormat::Fbx;
  if (begins(bytes, "ply\n") || begins(bytes, "ply\r")) return MeshFormat::Ply;
  if (begins(bytes, "# vtk DataFile")) return MeshFormat::VtkLegacy;
  const std::string_view start = trimmed(bytes.substr(0, 4096));
  const auto has = [&](std::string_view word) { return start.find(word) != std::string_view::npos; };
  if (begins(start, "<") && has("<VTKFile")) return MeshFormat::Vtp;
  if (begins(start, "<") && has("<COLLADA")) return MeshFormat::Dae;
  if (begins(start, "solid") && has("facet")) return MeshFormat::Stl;
  if (begins(start, "{") && has("\"asset\"")) return MeshFormat::Gltf;
  return std::nullopt;
}

}  // namespace glenoid
