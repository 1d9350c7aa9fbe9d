// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/render/Image.h"

#include <gtest/gtest.h>

#include <filesystem>

namespace glenoid {
namespace {

Image pattern(int width, int height, bool opaque) {
  Image image{width, height, {}};
  for (int y = 0; y < height; ++y)
    for (int x = 0; x < width; ++x)
      for (const int value : {7 * x + y, x * y, 255 - 3 * x, opaque ? 255 : 40 + x})
        image.rgba.push_back(static_cast<std::uint8_t>(value));
  return image;
}

TEST(Image, pngComesBackAsItWent) {
  for (const bool opaque : {true, false})
    for (const auto& [w, h] : {std::pair(1, 1), std::pair(17, 5), std::pair(64, 48)}) {
      const Image image = pattern(w, h, opaque);
      const auto bytes = encodePng(image, {{"Software", "test"}});
      ASSERT_TRUE(bytes.ok());
      const auto back = decodePng(*bytes);
      ASSERT_TRUE(back.ok()) << toLogLine(back.error());
      EXPECT_EQ(*back, image);
    }
}

TEST(Image, everyTruncationIsAnError) {
  const auto bytes = *encodePng(pattern(17, 5, true));
  for (std::size_t size = 0; size < bytes.size(); ++size)
    EXPECT_FALSE(decodePng({bytes.begin(), bytes.begin() + static_cast<long>(size)}).ok()) << size;
}

TEST(Image, everyFlippedByteIsAnErrorOrHarmless) {
  const auto bytes = *encodePng(pattern(17, 5, true));
  for (std::size_t i = 0; i < bytes.size(); ++i) {
    auto damaged = bytes;
    damaged[i] ^= 0x55;
    EXPECT_FALSE(decodePng(damaged).ok())
        << i;  // signature, length, type, data and check sum are all covered
  }
}

TEST(Image, faultsAreNamed) {
  EXPECT_EQ(readPng("no/such/picture.png").error().fault, Fault::FileMissing);
  EXPECT_EQ(readPng(".").error().fault, Fault::FileUnreadable);
  EXPECT_EQ(decodePng({}).error().fault, Fault::FileEmpty);
  EXPECT_EQ(decodePng({'G', 'I', 'F', '8', '9', 'a', 0, 0, 0, 0}).error().fault, Fault::UnknownFormat);
  EXPECT_EQ(encodePng({0, 0, {}}).error().fault, Fault::OutOfRange);
  EXPECT_EQ(writePng(pattern(2, 2, true), "no/such/folder/a.png").error().fault, Fault::FileUnwritable);
}

TEST(Image, differenceCountsWhatDiffers) {
  const Image a = pattern(10, 10, true);
  Image b = a;
  b.rgba[4 * 33] = static_cast<std::uint8_t>(b.rgba[4 * 33] ^ 0x80);
  const ImageDifference d = compareImages(a, b);
  EXPECT_TRUE(d.sameSize);
  EXPECT_NEAR(d.max, 128 / 255.0, 1e-12);
  EXPECT_NEAR(d.mean, 128 / 255.0 / 300, 1e-12);
  EXPECT_NEAR(d.fractionDifferent, 0.01, 1e-12);
  EXPECT_EQ(compareImages(a, a).max, 0);
  EXPECT_FALSE(compareImages(a, pattern(10, 9, true)).sameSize);
  EXPECT_EQ(compareImages(a, pattern(10, 9, true)).mean, 1);
}

}  // namespace
}  // namespace glenoid
