// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cstdlib>

#include "editor/render/Image.h"

namespace glenoid {

ImageDifference compareImages(const Image& a, const Image& b, double threshold) {
  ImageDifference difference;
  if (a.width != b.width || a.height != b.height || a.rgba.size() != b.rgba.size() || a.rgba.empty())
    return {1, 1, 1, false};
  difference.sameSize = true;
  double sum = 0;
  long different = 0;
  const std::size_t pixels = a.rgba.size() / 4;
  for (std::size_t i = 0; i < pixels; ++i) {
    int worst = 0;
    for (int c = 0; c < 3; ++c) {
      const int d = std::abs(int{a.rgba[4 * i + c]} - int{b.rgba[4 * i + c]});
      sum += d;
      worst = std::max(worst, d);
    }
    difference.max = std::max(difference.max, worst / 255.0);
    if (worst > threshold * 255) ++different;
  }
  difference.mean = sum / (255.0 * 3 * static_cast<double>(pixels));
  difference.fractionDifferent = static_cast<double>(different) / static_cast<double>(pixels);
  return difference;
}

Image differenceImage(const Image& a, const Image& b) {
  Image out{std::max(a.width, b.width), std::max(a.height, b.height), {}};
  out.rgba.assign(4 * static_cast<std::size_t>(out.width) * out.height, 255);
  for (int y = 0; y < std::min(a.height, b.height); ++y)
    for (int x = 0; x < std::min(a.width, b.width); ++x) {
      const auto p = a.at(x, y), q = b.at(x, y);
      std::uint8_t* o = out.rgba.data() + 4 * (static_cast<std::size_t>(y) * out.width + x);
      for (int c = 0; c < 3; ++c) o[c] = static_cast<std::uint8_t>(std::min(255, 4 * std::abs(p[c] - q[c])));
    }
  return out;
}

}  // namespace glenoid
