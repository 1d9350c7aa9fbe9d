// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/render/ColorMap.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

namespace glenoid {
namespace {

using Color = std::array<float, 3>;

double distance(const Color& a, const Color& b) {
  const auto x = labOf(a), y = labOf(b);
  return std::hypot(x[0] - y[0], x[1] - y[1], x[2] - y[2]);
}

/// What those see who have no cones for green (deuteranopia) or for red (protanopia). Source: Viénot, Brettel and Mollon,
/// "Digital video colourmaps for checking the legibility of displays by dichromats", Color Res. Appl. 24, 1999.
Color seenBy(bool protan, const Color& c) {
  const auto linear = [](float x) { return std::pow(x, 2.2); };
  const double r = linear(c[0]), g = linear(c[1]), b = linear(c[2]);
  const double red = protan ? 0.11238 * r + 0.88762 * g : 0.29275 * r + 0.70725 * g;
  const double blue = protan ? 0.00401 * r - 0.00401 * g + b : -0.02234 * r + 0.02234 * g + b;
  const auto encoded = [](double x) { return static_cast<float>(std::pow(std::clamp(x, 0.0, 1.0), 1 / 2.2)); };
  return {encoded(red), encoded(red), encoded(blue)};
}

TEST(ColorMap, labIsThatOfKnownColours) {
  const auto white = labOf({1, 1, 1}), red = labOf({1, 0, 0});
  EXPECT_NEAR(white[0], 100, 1e-3);
  EXPECT_NEAR(white[1], 0, 0.02);
  EXPECT_NEAR(red[0], 53.24, 0.02);  // published, D65
  EXPECT_NEAR(red[1], 80.09, 0.05);
  EXPECT_NEAR(red[2], 67.20, 0.05);
}

TEST(ColorMap, stepsAreEqualToTheEye) {
  for (const ColorMap map : {ColorMap::Sequential, ColorMap::Diverging}) {
    double least = 1e9, most = 0;
    for (int i = 0; i + 8 < 256; i += 8) {
      if (map == ColorMap::Diverging && i < 128 && i + 8 > 128) continue;
      const double step = distance(colorTable(map)[i], colorTable(map)[i + 8]);
      least = std::min(least, step), most = std::max(most, step);
    }
    std::printf("steps of eight: %.2f to %.2f; ends %d %d %d, %d %d %d\n", least, most, int(255 * colorTable(map)[0][0]), int(255 * colorTable(map)[0][1]),
                int(255 * colorTable(map)[0][2]), int(255 * colorTable(map)[255][0]), int(255 * colorTable(map)[255][1]), int(255 * colorTable(map)[255][2]));
    EXPECT_GT(least, 2.3) << "a just noticeable difference";
    EXPECT_LT(most / least, map == ColorMap::Sequential ? 1.1 : 1.6);
  }
}

TEST(ColorMap, lightnessAloneTellsTheOrder) {
  const auto lightness = [](ColorMap map, int i) { return labOf(colorTable(map)[i])[0]; };
  for (int i = 0; i < 255; ++i) EXPECT_GT(lightness(ColorMap::Sequential, i + 1), lightness(ColorMap::Sequential, i) - 1e-3) << i;
  EXPECT_GT(lightness(ColorMap::Sequential, 255) - lightness(ColorMap::Sequential, 0), 60);
  for (int i = 0; i < 128; ++i) EXPECT_GT(lightness(ColorMap::Diverging, i + 1), lightness(ColorMap::Diverging, i) - 1e-3) << i;
  for (int i = 128; i < 255; ++i) EXPECT_LT(lightness(ColorMap::Diverging, i + 1), lightness(ColorMap::Diverging, i) + 1e-3) << i;
}

TEST(ColorMap, thoseWithoutRedOrGreenTellValuesAndSignsApart) {
  for (const bool protan : {false, true}) {
    for (int i = 0; i + 32 < 256; i += 16)
      EXPECT_GT(distance(seenBy(protan, colorTable(ColorMap::Sequential)[i]), seenBy(protan, colorTable(ColorMap::Sequential)[i + 32])), 5) << i;
    for (int i = 16; i <= 127; i += 16)  // as far below zero as above
      EXPECT_GT(distance(seenBy(protan, colorTable(ColorMap::Diverging)[128 - i]), seenBy(protan, colorTable(ColorMap::Diverging)[128 + i])), 0.25 * i) << i;
  }
}

TEST(ColorMap, noColourIsTheNeutralOne) {
  for (const ColorMap map : {ColorMap::Sequential, ColorMap::Diverging})
    for (const Color& color : colorTable(map)) EXPECT_GT(distance(color, kNeutralColor), 12);
}

TEST(ColorMap, sharesAreClampedAndInterpolated) {
  const ColorTable& table = colorTable(ColorMap::Sequential);
  EXPECT_EQ(colorAt(ColorMap::Sequential, -3), table[0]);
  EXPECT_EQ(colorAt(ColorMap::Sequential, 7), table[255]);
  EXPECT_EQ(colorAt(ColorMap::Sequential, NAN), table[0]);
  for (int i = 0; i < 3; ++i)
    EXPECT_NEAR(colorAt(ColorMap::Sequential, 100.5 / 255)[i], 0.5 * (table[100][i] + table[101][i]), 1e-6);
}

}  // namespace
}  // namespace glenoid
