// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace glenoid {

/// Unpacks a zlib stream to at most `limit` bytes. Nothing when it is damaged or holds more.
std::optional<std::string> inflated(std::string_view packed, std::size_t limit);

}  // namespace glenoid
