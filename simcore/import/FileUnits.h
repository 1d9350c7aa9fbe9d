// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string_view>

namespace glenoid {

/// Metres per unit that the coordinates have once assimp has read a DAE file: it scales by the file's <unit> itself, so
/// the answer is 1 where there is one and nothing where there is none.
std::optional<double> daeUnit(std::string_view bytes);

/// Metres per unit of a 3MF file, which assimp drops: the attribute `unit` of its model, millimetres where that is not
/// named. Nothing when the model cannot be found or the unit is unknown.
/// Source: 3D Manufacturing Format, Core Specification 1.3, section 3.4.
std::optional<double> threeMfUnit(std::string_view bytes);

}  // namespace glenoid
