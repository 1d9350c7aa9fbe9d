// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/file/Vtk.h"

#include <algorithm>
#include <charconv>
#include <cstdio>

#include "simcore/file/AtomicWrite.h"
#include "simcore/file/ByteReader.h"

namespace glenoid {
namespace {

constexpr int kVtkTetra = 10;

std::string volumeText(double volume) {
  char text[40];
  std::snprintf(text, sizeof text, "%.6g m^3", volume);
  return text;
}

double longestEdge(const TetMesh& mesh, const std::array<int, 4>& tet) {
  double longest = 0;
  for (int a = 0; a < 4; ++a)
    for (int b = 0; b < a; ++b) longest = std::max(longest, (mesh.nodes[tet[a]] - mesh.nodes[tet[b]]).norm());
  return longest;
}

void appendNumber(double value, VtkEncoding encoding, std::string& out) {
  if (encoding == VtkEncoding::Binary) return appendBytes(value, std::endian::big, out);
  char digits[32];
  out.append(digits,
             std::to_chars(digits, digits + sizeof digits, value).ptr);  // shortest that reads back the same
  out += ' ';
}

void appendNumber(int value, VtkEncoding encoding, std::string& out) {
  if (encoding == VtkEncoding::Binary) return appendBytes(value, std::endian::big, out);
  out += std::to_string(value) + ' ';
}

}  // namespace

Result<Done> checkTetMesh(const TetMesh& mesh, const std::string& file) {
  const auto fail = [&](Fault fault, std::size_t element, Arguments arguments = {}) {
    return Error{fault, {file, {}, {}, static_cast<long>(element)}, std::move(arguments), {}};
  };
  if (mesh.tets.empty()) return Error{Fault::BadMesh, {file, {}, {}, {}}, {"no tetrahedra"}, {}};
  for (std::size_t i = 0; i < mesh.nodes.size(); ++i)
    if (!mesh.nodes[i].allFinite()) return fail(Fault::NotFinite, i);
  const auto size = static_cast<int>(mesh.nodes.size());
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    for (const int index : mesh.tets[i])
      if (index < 0 || index >= size)
        return fail(Fault::BadIndex, i, {std::to_string(index), std::to_string(size)});
    const double volume = tetVolume(mesh, static_cast<int>(i)), edge = longestEdge(mesh, mesh.tets[i]);
    // Written so that an overflow to NaN counts as no volume.
    if (!(volume > kFlatTetrahedron * edge * edge * edge))
      return fail(Fault::BadElement, i, {volumeText(volume)});
  }
  return Done{};
}

Result<Done> writeVtk(const std::string& path, const TetMesh& mesh, VtkEncoding encoding) {
  if (const auto good = checkTetMesh(mesh, path); !good) return good;
  const bool ascii = encoding == VtkEncoding::Ascii;
  const std::string tets = std::to_string(mesh.tets.size());
  std::string bytes = "# vtk DataFile Version 3.0\ntetrahedra\n";
  bytes += ascii ? "ASCII\n" : "BINARY\n";
  bytes += "DATASET UNSTRUCTURED_GRID\nPOINTS " + std::to_string(mesh.nodes.size()) + " double\n";
  for (const Vec3& x : mesh.nodes) {
    for (const double value : x) appendNumber(value, encoding, bytes);
    if (ascii) bytes += '\n';
  }
  bytes += "\nCELLS " + tets + " " + std::to_string(mesh.tets.size() * 5) + "\n";
  for (const auto& tet : mesh.tets) {
    appendNumber(4, encoding, bytes);
    for (const int index : tet) appendNumber(index, encoding, bytes);
    if (ascii) bytes += '\n';
  }
  bytes += "\nCELL_TYPES " + tets + "\n";
  for (std::size_t i = 0; i < mesh.tets.size(); ++i) {
    appendNumber(kVtkTetra, encoding, bytes);
    if (ascii) bytes += '\n';
  }
  bytes += '\n';
  return writeWholeFile(path, bytes);
}

Result<TetMesh> readVtk(const std::string& path) {
  const Result<std::string> bytes = readWholeFile(path);
  if (!bytes) return bytes.error();
  return parseVtk(*bytes, path);
}

}  // namespace glenoid
