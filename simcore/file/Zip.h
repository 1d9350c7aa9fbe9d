// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "simcore/base/Error.h"

/// Zip archives, in and out of memory (libzip inside). Names are UTF-8 with '/' between folders.
namespace glenoid {

/// What an archive from outside may cost.
struct ZipLimits {
  int entries = 20000;
  std::uint64_t entryBytes = 1ull << 30;  ///< of one, unpacked
  std::uint64_t bytes = 2ull << 30;       ///< of all together, unpacked
};

struct ZipEntry {
  std::string name, bytes;
};

/// Takes one file of an archive.
using ZipSink = std::function<Result<Done>(const std::string& name, std::string_view bytes)>;

/// Gives every file of an archive to `sink`, in the archive's order; folders are passed over. Before the first one all names and
/// sizes are looked at, and each is held to its size while it is unpacked. Fails as readWholeFile does, with UnknownFormat (no
/// zip), FileTruncated, HashMismatch (a checksum), FileTooLarge (arguments: size, limit), DuplicateId (a name twice), SchemaMismatch
/// (arguments: what; a name that is absolute or leaves its folder, a link, an encrypted or unknown entry, more content than
/// declared), and as the sink does.
Result<Done> readZip(const std::string& path, const ZipSink& sink, const ZipLimits& limits = {});

/// Whether an entry of this name stays in the folder that it is unpacked to, on any system.
bool isSafeEntryName(std::string_view name);

/// Writes the archive as a whole or not at all. Times are left out: the same entries give the same bytes. Fails as writeWholeFile
/// does; Internal where libzip does (as for no entries at all).
Result<Done> writeZip(const std::string& path, const std::vector<ZipEntry>& entries);

}  // namespace glenoid
