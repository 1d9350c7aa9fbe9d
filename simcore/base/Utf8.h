// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>

namespace glenoid {

/// Whether the bytes are UTF-8: no overlong form, no surrogate, nothing beyond U+10FFFF. Source: RFC 3629.
bool isUtf8(std::string_view bytes);

/// The bytes where they are UTF-8; else each byte as a character of ISO 8859-1, which is what older programs wrote names in.
std::string asUtf8(std::string_view bytes);

}  // namespace glenoid
