// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string_view>

namespace glenoid {

/// Metres per unit that the coordinates have once assimp has read a DAE file: it scales by the file's <unit> itself, so
/// the answer is 1 where there is one and nothing where there is none.
std::optional<double> daeUnit(std::string_view bytes);

}  // namespace glenoid
