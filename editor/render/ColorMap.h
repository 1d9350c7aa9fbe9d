// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>

namespace glenoid {

/// Colours of a scale, from its low to its high end.
enum class ColorMap {
  Sequential,  ///< dark violet, blue, green, pale yellow: lightness alone tells the order
  Diverging    ///< blue, near white, orange: the middle is zero, and either sign has a hue that everybody tells apart
};

/// 256 colours, sRGB 0…1, of equal steps to the eye: a path in lightness, chroma and hue (Oklab), cut back to what a
/// screen has, then divided evenly by distance in CIELAB. Lightness never turns back (on either side of a diverging map's
/// middle), so that a map is read without colour and by those who see no red or green. Computed once.
/// Sources: Ottosson, "A perceptual color space for image processing", 2020 (Oklab); CIE 15:2004 (CIELAB, D65); Kovesi,
/// "Good colour maps: how to design them", 2015, and Moreland, "Diverging color maps for scientific visualization", 2009 (why).
using ColorTable = std::array<std::array<float, 3>, 256>;
const ColorTable& colorTable(ColorMap map);

/// At a share of the scale, 0…1, clamped; between two entries of the table in a straight line. NaN is 0.
std::array<float, 3> colorAt(ColorMap map, double share);

/// Of what has no value, sRGB: a middle grey that no map holds.
inline constexpr std::array<float, 3> kNeutralColor{0.56f, 0.57f, 0.59f};

/// CIELAB of an sRGB colour, D65: L 0…100.
std::array<double, 3> labOf(const std::array<float, 3>& srgb);

}  // namespace glenoid
