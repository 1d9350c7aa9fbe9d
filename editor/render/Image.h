// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "simcore/base/Error.h"

namespace glenoid {

/// Picture of 8-bit RGBA, sRGB, alpha not premultiplied. First row is the top, no padding between rows.
struct Image {
  int width = 0, height = 0;
  std::vector<std::uint8_t> rgba;  ///< 4 · width · height

  std::array<std::uint8_t, 4> at(int x, int y) const {
    const std::uint8_t* p = rgba.data() + 4 * (static_cast<std::size_t>(y) * width + x);
    return {p[0], p[1], p[2], p[3]};
  }
  bool operator==(const Image&) const = default;
};

/// Largest side that is read or written, pixels: protects memory against a damaged file.
inline constexpr int kImageSideMax = 16384;

/// PNG, 8-bit RGBA; pictures that are opaque everywhere are written as RGB. `text` goes into tEXt chunks
/// (keyword, value; Latin-1). Fails with FileUnwritable or OutOfRange (empty or oversized picture).
Result<Done> writePng(const Image& image, const std::string& path,
                      const std::vector<std::array<std::string, 2>>& text = {});

/// The same as bytes in memory.
Result<std::vector<std::uint8_t>> encodePng(const Image& image,
                                            const std::vector<std::array<std::string, 2>>& text = {});

/// Reads PNG of 8-bit grey, grey+alpha, RGB or RGBA, not interlaced (what writePng and common tools make).
/// Fails with FileMissing, FileEmpty, FileTruncated, FileTooLarge, UnknownFormat or HashMismatch (check sum).
Result<Image> readPng(const std::string& path);
Result<Image> decodePng(const std::vector<std::uint8_t>& bytes);

/// How far two pictures are apart, over all pixels and the three colours, 0…1 of full scale.
struct ImageDifference {
  double mean = 0;               ///< mean absolute difference
  double max = 0;                ///< largest
  double fractionDifferent = 0;  ///< share of pixels where some colour differs by more than the threshold
  bool sameSize = false;         ///< false: the others are 1
};
ImageDifference compareImages(const Image& a, const Image& b, double threshold = 0.06);

/// Absolute difference, stretched fourfold, opaque: what a person looks at when a test fails.
Image differenceImage(const Image& a, const Image& b);

}  // namespace glenoid
