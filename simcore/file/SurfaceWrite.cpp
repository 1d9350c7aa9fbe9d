// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/file/SurfaceWrite.h"

#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>
#include <cstdint>
#include <filesystem>
#include <limits>

#include "simcore/file/AtomicWrite.h"
#include "simcore/file/ByteReader.h"
#include "simcore/file/Ply.h"

namespace glenoid {

namespace {

/// Lower case, with the dot.
std::string endingOf(const std::string& path) {
  std::string ending = std::filesystem::path(path).extension().string();
  for (char& c : ending)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return ending;
}

/// What no format can hold.
Result<Done> checked(const std::string& path, const TriMesh& mesh, double largest) {
  if (mesh.triangles.empty()) return Error{Fault::BadMesh, {path, {}, {}, {}}, {"no triangles"}, {}};
  const auto size = static_cast<int>(mesh.vertices.size());
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i)
    if (!mesh.vertices[i].allFinite() || mesh.vertices[i].cwiseAbs().maxCoeff() > largest)
      return Error{Fault::NotFinite, {path, {}, {}, static_cast<long>(i)}, {}, {}};
  for (std::size_t i = 0; i < mesh.triangles.size(); ++i)
    for (const int index : mesh.triangles[i])
      if (index < 0 || index >= size)
        return Error{Fault::BadIndex, {path, {}, {}, static_cast<long>(i)}, {std::to_string(index), std::to_string(size)}, {}};
  return Done{};
}

Result<Done> writeObj(const std::string& path, const TriMesh& mesh) {
  if (const auto sound = checked(path, mesh, HUGE_VAL); !sound) return sound;
  std::string text = "# Glenoid Studio\n";
  char number[32];
  for (const Vec3& v : mesh.vertices) {
    text += 'v';
    for (const double x : v) text.append(" ").append(number, std::to_chars(number, number + sizeof number, x).ptr);
    text += '\n';
  }
  for (const auto& t : mesh.triangles)
    text += "f " + std::to_string(t[0] + 1) + ' ' + std::to_string(t[1] + 1) + ' ' + std::to_string(t[2] + 1) + '\n';
  return writeWholeFile(path, text);
}

Result<Done> writeStl(const std::string& path, const TriMesh& mesh) {
  if (const auto sound = checked(path, mesh, std::numeric_limits<float>::max()); !sound) return sound;
  std::string bytes(80, ' ');
  const std::string title = "Glenoid Studio";  // no “solid”: readers take that for the text format
  std::copy(title.begin(), title.end(), bytes.begin());
  bytes.reserve(84 + 50 * mesh.triangles.size());
  appendBytes(static_cast<std::uint32_t>(mesh.triangles.size()), std::endian::little, bytes);
  const auto append = [&](const Vec3& v) {
    for (const double x : v) appendBytes(static_cast<float>(x), std::endian::little, bytes);
  };
  for (const auto& t : mesh.triangles) {
    const Vec3 &a = mesh.vertices[t[0]], &b = mesh.vertices[t[1]], &c = mesh.vertices[t[2]];
    append((b - a).cross(c - a).normalized());  // nothing where it has no area, as the format wants it
    for (const Vec3& corner : {a, b, c}) append(corner);
    appendBytes(std::uint16_t{0}, std::endian::little, bytes);
  }
  return writeWholeFile(path, bytes);
}

}  // namespace

std::string writtenFormat(const std::string& path) {
  const std::string ending = endingOf(path);
  return ending == ".ply" ? "PLY" : ending == ".stl" ? "STL" : ending == ".obj" ? "OBJ" : "";
}

Result<Done> writeSurface(const std::string& path, const TriMesh& mesh) {
  const std::string format = writtenFormat(path);
  if (format == "STL") return writeStl(path, mesh);
  if (format == "OBJ") return writeObj(path, mesh);
  if (format == "PLY") return writePly(path, mesh);
  return Error{Fault::UnknownFormat, {path, {}, {}, {}}, {}, "surfaces are written as PLY, STL or OBJ"};
}

}  // namespace glenoid
