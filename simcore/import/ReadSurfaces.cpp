// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/import/ReadSurfaces.h"

#include "simcore/base/Utf8.h"
#include "simcore/file/AtomicWrite.h"
#include "simcore/file/Ply.h"
#include "simcore/import/AssimpRead.h"
#include "simcore/import/FileAxes.h"
#include "simcore/import/gltf/GltfExtensions.h"
#include "simcore/import/gltf/GltfPlain.h"
#include "simcore/import/MeshFormat.h"
#include "simcore/import/TextSurfaces.h"
#include "simcore/import/ThreeMf.h"
#include "simcore/import/vtk/VtkSurface.h"

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

Result<ImportedFile> readNamed(const std::string& path, MeshFormat format, long long triangles, const TextSurfaces& text) {
  Result<ImportedFile> file = readWithAssimp(path, format, triangles, {text.bytes, {}});
  if (file) nameSurfaces(text, format == MeshFormat::Obj, file->surfaces);
  return file;
}

Result<ImportedFile> readGltf(const std::string& bytes, const std::string& path, MeshFormat format, long long triangles) {
  if (const auto unknown = extensionsNotUnderstood(bytes, format == MeshFormat::Glb); !unknown.empty()) {
    std::string names;
    for (const std::string& name : unknown) names += (names.empty() ? "" : ", ") + name;
    return Error{Fault::BadMesh, {path, {}, {}, {}}, {"it requires what is not understood here (" + names + "): write it without that, or in another format"}, "glTF"};
  }
  const auto plain = plainGltf(bytes, path, format == MeshFormat::Glb);
  if (!plain) return plain.error();
  if (!*plain) return readWithAssimp(path, format, triangles);
  Result<ImportedFile> file = readWithAssimp(path, format, triangles, {(*plain)->bytes, (*plain)->beside});
  if (!file) return file;
  addNote(file->notes, ImportNote::NodesMoved, (*plain)->skins);
  addNote(file->notes, ImportNote::AnimationsDropped, (*plain)->lost);
  return file;
}

Result<ImportedFile> readObj(const std::string& bytes, const std::string& path, long long triangles) {
  Result<ImportedFile> file = readNamed(path, MeshFormat::Obj, triangles, objForReader(bytes));
  if (!file) return file;
  const ObjComments comments = objComments(bytes);
  if (!comments.name.empty() && file->surfaces.size() == 1) file->surfaces[0].name = comments.name;
  if (!file->metresPerUnit) file->metresPerUnit = comments.metresPerUnit;
  return file;
}

Result<ImportedFile> readBytes(const std::string& bytes, const std::string& path, MeshFormat format, long long triangles) {
  switch (format) {
    case MeshFormat::Ply: return parsePlySurface(bytes, path);
    case MeshFormat::Vtp:
    case MeshFormat::Vtu: return parseVtp(bytes, path);
    case MeshFormat::VtkLegacy: return parseVtkSurface(bytes, path);
    case MeshFormat::Stl: {
      const Result<TextSurfaces> text = stlForReader(bytes, path);
      if (!text) return text.error();
      return readNamed(path, format, triangles, *text);
    }
    case MeshFormat::Gltf:
    case MeshFormat::Glb: return readGltf(bytes, path, format, triangles);
    case MeshFormat::Obj: return readObj(bytes, path, triangles);
    case MeshFormat::ThreeMf: return readThreeMf(path, triangles);
    default: return readWithAssimp(path, format, triangles);
  }
}

Result<ImportedFile> readAsItIs(const std::string& path, long long triangles) {
  auto format = formatByEnding(path);
  if (!format) return Error{Fault::UnknownFormat, {path, {}, {}, {}}, {}, "import"};
  const Result<std::string> bytes = readWholeFile(path);
  if (!bytes) return bytes.error();
  if (const std::string instead = notTheFile(*bytes); !instead.empty()) return Error{Fault::BadMesh, {path, {}, {}, {}}, {instead}, "import"};
  if (const auto seen = formatByContent(*bytes)) format = seen;  // the bytes know better than the name
  Result<ImportedFile> file = readBytes(*bytes, path, *format, triangles);
  if (file && file->axes == FileAxes::Unsaid) file->axes = axesSaidIn(*bytes, *format);
  return file;
}

}  // namespace

Result<ImportedFile> readSurfaces(const std::string& path, long long triangles) {
  Result<ImportedFile> file = readAsItIs(path, triangles);
  if (file)
    for (ImportedSurface& surface : file->surfaces) surface.name = asUtf8(surface.name);
  return file;
}

}  // namespace glenoid
