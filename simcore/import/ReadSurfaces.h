// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "simcore/base/Error.h"
#include "simcore/import/ImportedFile.h"

namespace glenoid {

/// Reads a file of surfaces in this process, with the reader its content and ending ask for. For the worker
/// `glenoid-import`; everybody else calls importSurfaces. Fails with UnknownFormat and as the readers do.
Result<ImportedFile> readSurfaces(const std::string& path, long long triangles);

}  // namespace glenoid
