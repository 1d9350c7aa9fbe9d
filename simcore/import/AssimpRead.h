// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>

#include "simcore/base/Error.h"
#include "simcore/import/ImportedFile.h"
#include "simcore/import/MeshFormat.h"

namespace glenoid {

/// Bytes that stand for a file's own, where there are any, and those of a file called `kBesideName` beside it. Whoever owns them
/// keeps them while the file is read.
struct InsteadOfFile {
  std::string_view bytes, beside;
};
inline constexpr const char* kBesideName = "glenoid-beside.bin";

/// Reads OBJ, STL, glTF, GLB, DAE or FBX through assimp. Only the loader of that format is asked, and it can open
/// only regular files in the folder of `path` and below. A damaged file can crash it, hang it or eat memory: this is
/// for the worker `glenoid-import`, never for the studio. Coordinates have single precision, as assimp keeps them.
/// One surface for each node that carries meshes; `triangles` is the most that all together may have.
/// Fails with BadMesh (argument: assimp's own words), NotFinite, BadIndex, FileTooLarge (arguments: triangles, limit).
Result<ImportedFile> readWithAssimp(const std::string& path, MeshFormat format, long long triangles, const InsteadOfFile& instead = {});

}  // namespace glenoid
