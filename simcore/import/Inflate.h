// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace glenoid {

/// Unpacks a zlib stream (or, with `raw`, a bare deflate stream as zip files hold) to at most `limit` bytes. Nothing
/// when it is damaged or holds more.
std::optional<std::string> inflated(std::string_view packed, std::size_t limit, bool raw = false);

/// One member of a zip file by its whole name, any case, at most `limit` bytes. Members that are encrypted, split or
/// packed otherwise than by deflate are as if they were not there. Source: PKWARE, APPNOTE.TXT 6.3.10.
std::optional<std::string> zipMember(std::string_view zip, std::string_view name, std::size_t limit);

}  // namespace glenoid
