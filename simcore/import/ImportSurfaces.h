// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <functional>
#include <string>

#include "simcore/base/Error.h"
#include "simcore/import/ImportedFile.h"

namespace glenoid {

/// What a file from outside may cost, and how the reader is found.
struct ImportLimits {
  std::uint64_t memory = 2ull << 30;      ///< bytes of address space of the reader
  double seconds = 60;                    ///< of wall time; then it is killed
  std::uint64_t fileBytes = 1ull << 30;   ///< larger files are not begun
  long long triangles = 20'000'000;       ///< of all surfaces together
  std::string worker;                     ///< path of glenoid-import; empty: see findImportWorker
  std::function<bool()> cancelled;        ///< asked some twenty times a second, on the calling thread
};

/// The reader's program: what the environment variable GLENOID_IMPORT names, else `glenoid-import` beside the running
/// program.
std::string findImportWorker();

/// Reads surfaces from a file of OBJ, STL, PLY, glTF, GLB, 3MF, DAE, FBX, VTP or legacy VTK. A process of its own parses
/// it, within limits on memory and time; this one only believes an answer whose every count, index and number has been
/// checked. So a file that crashes or hangs its reader costs an error, never the program. Blocks until done; any thread.
/// Fails with FileMissing (also of the worker), FileUnreadable, FileEmpty, FileTooLarge, UnknownFormat, ReaderStopped
/// (it broke down), TimedOut (argument: seconds), OutOfMemory (argument: limit), Cancelled, and as the readers do.
Result<ImportedFile> importSurfaces(const std::string& path, const ImportLimits& limits = {});

}  // namespace glenoid
