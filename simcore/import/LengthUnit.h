// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <optional>
#include <string_view>

namespace glenoid {

/// Units in which surface files come. Word as in recipes and on the command line, and its length in metres.
struct LengthUnit {
  std::string_view word;
  double metres;
};

inline constexpr std::array<LengthUnit, 6> kLengthUnits{
    {{"mm", 1e-3}, {"cm", 1e-2}, {"m", 1}, {"inch", 0.0254}, {"ft", 0.3048}, {"um", 1e-6}}};

inline std::optional<double> metresIn(std::string_view word) {
  for (const LengthUnit& unit : kLengthUnits)
    if (unit.word == word) return unit.metres;
  return std::nullopt;
}

/// Word of a unit of this many metres (within 0.1 %); empty when it has none.
inline std::string_view unitWord(double metres) {
  for (const LengthUnit& unit : kLengthUnits)
    if (metres > 0.999 * unit.metres && metres < 1.001 * unit.metres) return unit.word;
  return {};
}

}  // namespace glenoid
