// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "simcore/base/Error.h"
#include "simcore/import/ImportedFile.h"

namespace glenoid {

/// Reads a 3MF package (libzip and pugixml inside): what its build holds, each mesh with its transforms, under its object's name
/// or that which slicers keep beside the model. Objects may lie in model files of their own (production extension). `triangles`
/// is the most that all together may have; as meshes are built from parts that repeat, that holds for what comes out.
/// Units are the model's; one file's surfaces all have the unit of the model that the package begins with.
/// Fails as readZip does, with BadMesh (argument: what, an extension that is required and not understood by its name),
/// NotFinite, BadIndex, CyclicReference (argument: object), FileTooLarge (arguments: triangles, limit).
/// Sources: 3MF Core Specification 1.3; 3MF Production Extension 1.1.2.
Result<ImportedFile> readThreeMf(const std::string& path, long long triangles);

}  // namespace glenoid
