// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <string>
#include <string_view>

#include "simcore/base/Error.h"

namespace glenoid {

/// Whole files in one go. Paths are UTF-8; a relative one starts at the working folder.

/// No file of ours is larger; protects memory when somebody opens a film by mistake.
inline constexpr std::uint64_t kFileLimit = 1ull << 30;  // bytes

/// Every byte of a regular file. Fails with FileMissing, FileUnreadable (no permission, a folder, a pipe or
/// device), FileEmpty or FileTooLarge (arguments: size, limit).
Result<std::string> readWholeFile(const std::string& path, std::uint64_t limit = kFileLimit);

/// Puts the bytes under this name so that a reader sees the old content or the new one, never a piece: they go
/// to a new file in the same folder, reach the disk, then take the name. A symbolic link keeps pointing where it
/// pointed. Fails with FileMissing (no such folder) or FileUnwritable; the old file is then as it was.
Result<Done> writeWholeFile(const std::string& path, std::string_view bytes);

/// Whether that would go now: fails as it does, and leaves nothing behind. To be asked before long work.
Result<Done> checkWritable(const std::string& path);

}  // namespace glenoid
