// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/import/ReadSurfaces.h"

#include "simcore/file/AtomicWrite.h"
#include "simcore/file/Ply.h"
#include "simcore/import/AssimpRead.h"
#include "simcore/import/MeshFormat.h"
#include "simcore/import/VtkSurface.h"

namespace glenoid {
namespace {

Result<ImportedFile> parsePlySurface(std::string_view bytes, const std::string& path) {
  PlyNotes notes;
  Result<TriMesh> mesh = parsePly(bytes, path, &notes);
  if (!mesh) return mesh.error();
  if (mesh->triangles.empty()) return Error{Fault::BadMesh, {path, {}, {}, {}}, {"it holds no triangles"}, {}};
  ImportedFile file;
  file.format = "PLY";
  addNote(file.notes, ImportNote::PolygonsSplit, notes.polygonsSplit);
  file.surfaces.push_back({{}, std::move(*mesh)});
  return file;
}

}  // namespace

Result<ImportedFile> readSurfaces(const std::string& path, long long triangles) {
  const Error unknown{Fault::UnknownFormat, {path, {}, {}, {}}, {}, "import"};
  auto format = formatByEnding(path);
  if (!format) return unknown;
  const Result<std::string> bytes = readWholeFile(path);
  if (!bytes) return bytes.error();
  if (const auto seen = formatByContent(*bytes)) format = seen;  // the bytes know better than the name
  switch (*format) {
    case MeshFormat::Ply: return parsePlySurface(*bytes, path);
    case MeshFormat::Vtp: return parseVtp(*bytes, path);
    case MeshFormat::VtkLegacy: return parseVtkSurface(*bytes, path);
    default: return readWithAssimp(path, *format, triangles);
  }
}

}  // namespace glenoid
