// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "simcore/file/JsonValue.h"
#include "simcore/import/ImportedFile.h"
#include "simcore/repair/Diagnose.h"

namespace glenoid {

/// What `mesh info` says about one file, for people and for programs.
std::string meshInfoText(const std::string& path, const ImportedFile& file, const std::vector<SurfaceDiagnosis>& diagnoses);
JsonValue meshInfoJson(const std::string& path, const ImportedFile& file, const std::vector<SurfaceDiagnosis>& diagnoses);

/// What `mesh repair` did, a line for each step.
std::string repairText(const std::vector<RepairChange>& changes, double metresPerUnit);

}  // namespace glenoid
