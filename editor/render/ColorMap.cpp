// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/render/ColorMap.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "simcore/base/Math.h"

namespace glenoid {
namespace {

/// A place on a path: lightness 0…1, chroma, hue in degrees (Oklab).
struct Knot {
  double light, chroma, hue;
};

Vec3 linearOf(double light, double chroma, double hue) {
  const double a = chroma * std::cos(hue * M_PI / 180), b = chroma * std::sin(hue * M_PI / 180);
  const auto cube = [](double x) { return x * x * x; };
  const double l = cube(light + 0.3963377774 * a + 0.2158037573 * b), m = cube(light - 0.1055613458 * a - 0.0638541728 * b),
               s = cube(light - 0.0894841775 * a - 1.2914855480 * b);
  return {4.0767416621 * l - 3.3077115913 * m + 0.2309699292 * s, -1.2684380046 * l + 2.6097574011 * m - 0.3413193965 * s,
          -0.0041960863 * l - 0.7034186147 * m + 1.7076147010 * s};
}

/// The same with as much chroma as a screen has.
Vec3 shownOf(const Knot& k) {
  const auto fits = [&](double share) {
    const Vec3 c = linearOf(k.light, share * k.chroma, k.hue);
    return c.minCoeff() >= 0 && c.maxCoeff() <= 1;
  };
  double low = 0, high = 1;
  if (!fits(1)) {
    for (int i = 0; i < 40; ++i) (fits(0.5 * (low + high)) ? low : high) = 0.5 * (low + high);
  } else {
    low = 1;
  }
  return linearOf(k.light, low * k.chroma, k.hue).cwiseMax(0).cwiseMin(1);
}

Vec3 labOfLinear(const Vec3& c) {
  const Vec3 xyz((0.4124564 * c.x() + 0.3575761 * c.y() + 0.1804375 * c.z()) / 0.95047,
                 0.2126729 * c.x() + 0.7151522 * c.y() + 0.0721750 * c.z(),
                 (0.0193339 * c.x() + 0.1191920 * c.y() + 0.9503041 * c.z()) / 1.08883);
  const Vec3 f = xyz.unaryExpr([](double x) { return x > 0.008856 ? std::cbrt(x) : 7.787 * x + 16.0 / 116; });
  return {116 * f.y() - 16, 500 * (f.x() - f.y()), 200 * (f.y() - f.z())};
}

std::array<float, 3> encoded(const Vec3& c) {
  std::array<float, 3> out;
  for (int i = 0; i < 3; ++i) out[i] = static_cast<float>(c[i] <= 0.0031308 ? 12.92 * c[i] : 1.055 * std::pow(c[i], 1 / 2.4) - 0.055);
  return out;
}

/// Places `from`…`to` of a table along a path, in equal steps of CIELAB.
void lay(const std::vector<Knot>& path, int from, int to, ColorTable& table) {
  constexpr int kFine = 4000;
  std::vector<Vec3> fine;
  std::vector<double> way{0};
  for (int i = 0; i <= kFine; ++i) {
    const double at = static_cast<double>(i) / kFine * static_cast<double>(path.size() - 1);
    const std::size_t k = std::min(static_cast<std::size_t>(at), path.size() - 2);
    const double t = at - static_cast<double>(k);
    const auto mix = [t](double a, double b) { return a + t * (b - a); };
    fine.push_back(shownOf({mix(path[k].light, path[k + 1].light), mix(path[k].chroma, path[k + 1].chroma), mix(path[k].hue, path[k + 1].hue)}));
    if (i > 0) way.push_back(way.back() + (labOfLinear(fine[i]) - labOfLinear(fine[i - 1])).norm());
  }
  for (int n = from; n <= to; ++n) {
    const double wanted = way.back() * (n - from) / (to - from);
    const auto after = std::lower_bound(way.begin(), way.end(), wanted) - way.begin();
    table[n] = encoded(fine[std::min<std::ptrdiff_t>(after, kFine)]);
  }
}

ColorTable made(ColorMap map) {
  ColorTable table;
  if (map == ColorMap::Sequential) {
    // Lightness in a straight line; hue from violet through blue and green to yellow.
    lay({{0.33, 0.135, 292}, {0.48, 0.13, 262}, {0.63, 0.12, 205}, {0.78, 0.15, 152}, {0.93, 0.165, 108}}, 0, 255, table);
  } else {
    lay({{0.40, 0.14, 262}, {0.62, 0.12, 253}, {0.82, 0.06, 248}, {0.955, 0.004, 245}}, 0, 128, table);
    lay({{0.955, 0.004, 80}, {0.84, 0.08, 70}, {0.68, 0.145, 55}, {0.45, 0.15, 38}}, 128, 255, table);
  }
  return table;
}

}  // namespace

const ColorTable& colorTable(ColorMap map) {
  static const ColorTable sequential = made(ColorMap::Sequential), diverging = made(ColorMap::Diverging);
  return map == ColorMap::Sequential ? sequential : diverging;
}

std::array<float, 3> colorAt(ColorMap map, double share) {
  const double at = 255 * (share > 0 ? std::min(share, 1.0) : 0);
  const int below = std::min(static_cast<int>(at), 254);
  const float t = static_cast<float>(at - below);
  std::array<float, 3> out;
  for (int i = 0; i < 3; ++i) out[i] = (1 - t) * colorTable(map)[below][i] + t * colorTable(map)[below + 1][i];
  return out;
}

std::array<double, 3> labOf(const std::array<float, 3>& srgb) {
  Vec3 c;
  for (int i = 0; i < 3; ++i) c[i] = srgb[i] <= 0.04045 ? srgb[i] / 12.92 : std::pow((srgb[i] + 0.055) / 1.055, 2.4);
  const Vec3 lab = labOfLinear(c);
  return {lab.x(), lab.y(), lab.z()};
}

}  // namespace glenoid
