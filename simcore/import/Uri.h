// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>
#include <string_view>

namespace glenoid {

/// Percent-encoded bytes of a URI as they are.
std::string decodedUri(std::string_view uri);

/// A regular file that a URI names, in the folder of `path` or below; by its name as written or, where that is none, decoded.
/// Empty for anything else.
std::string fileBeside(const std::string& path, std::string_view uri);

/// What a data: URI holds in base64. Nothing where it is another kind, or damaged.
std::optional<std::string> bytesOfDataUri(std::string_view uri);

}  // namespace glenoid
