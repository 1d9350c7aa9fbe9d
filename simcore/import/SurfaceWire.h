// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>

#include "simcore/base/Error.h"
#include "simcore/import/ImportedFile.h"

namespace glenoid {

/// What the worker sends to the program that started it: a file or the reason why there is none, as bytes that are
/// checked before they are believed. Little endian, one machine, one build: not a file format.
std::string toWire(const Result<ImportedFile>& result);

/// Judges every count against the bytes that are there, every index, note and number; whatever does not fit answers
/// ReaderStopped. Error places get `file` as their file.
Result<ImportedFile> fromWire(std::string_view bytes, const std::string& file);

}  // namespace glenoid
