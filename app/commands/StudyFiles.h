// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "simcore/base/Error.h"
#include "simcore/file/JsonValue.h"
#include "simcore/study/StudyTable.h"

namespace glenoid {

/// Comma-separated values as RFC 4180 has them, the first line the columns' keys; a cell without a figure is empty, and so is one that
/// is not finite. Numbers come back bit for bit.
std::string tableCsv(const StudyTable& table);

/// What names the machine and program of a study: build, isa, processor, threads.
JsonValue machineJson();

/// "Intel … , build 1a2b, kernels avx2-fma, one thread": for a plot's or a text's small print.
std::string machineWords();

/// A file of a study's folder.
std::string inFolder(const std::string& folder, const std::string& leaf);

/// Makes the folder where it is not there, and tells whether files can be written in it. Fails with FileUnwritable, FileMissing.
Result<Done> prepareFolder(const std::string& folder);

/// "scenes/knee.scenario.json" → "scenes/out/../knee.joint" made as short as it goes: a path that stands in a file of one folder, for a file
/// in another. "builtin:NAME", the empty and absolute paths stay.
std::string movedReference(const std::string& reference, const std::string& fromFolder, const std::string& toFolder);

}  // namespace glenoid
