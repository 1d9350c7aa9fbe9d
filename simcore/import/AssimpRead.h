// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>

#include "simcore/base/Error.h"
#include "simcore/import/ImportedFile.h"
#include "simcore/import/MeshFormat.h"

namespace glenoid {

/// Reads OBJ, STL, glTF, GLB, 3MF, DAE or FBX through assimp. Only the loader of that format is asked, and it can open
/// only regular files in the folder of `path` and below. A damaged file can crash it, hang it or eat memory: this is
/// for the worker `glenoid-import`, never for the studio. Coordinates have single precision, as assimp keeps them.
/// `instead`: bytes that stand for the file's own, where there are any; they must outlive the call.
/// One surface for each node that carries meshes; `triangles` is the most that all together may have.
/// Fails with BadMesh (argument: assimp's own words), NotFinite, BadIndex, FileTooLarge (arguments: triangles, limit).
Result<ImportedFile> readWithAssimp(const std::string& path, MeshFormat format, long long triangles, std::string_view instead = {});

}  // namespace glenoid
