// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/base/Utf8.h"

#include <gtest/gtest.h>

namespace glenoid {
namespace {

TEST(Utf8, isToldFromOtherBytes) {
  for (const char* good : {"", "plain", "Hüfte – links", "骨", "\xf0\x9f\xa6\xb4", "\xef\xbf\xbf", "\xf4\x8f\xbf\xbf", "\xed\x9f\xbf", "\xee\x80\x80"}) EXPECT_TRUE(isUtf8(good)) << good;
  EXPECT_TRUE(isUtf8(std::string_view("a\0b", 3)));
  // RFC 3629, sections 3 and 4: a byte that stands alone, one cut short, overlong forms, surrogates, beyond the last character.
  for (const char* bad : {"H\xfc" "fte", "\x80", "\xc3", "a\xe2\x80", "\xf0\x9f\xa6", "\xc0\x80", "\xc1\xbf", "\xe0\x80\x80", "\xe0\x9f\xbf", "\xf0\x80\x80\x80",
                          "\xf0\x8f\xbf\xbf", "\xed\xa0\x80", "\xed\xbf\xbf", "\xf4\x90\x80\x80", "\xf5\x80\x80\x80", "\xff", "\xc3\xc3", "\xe2\x28\xa1"})
    EXPECT_FALSE(isUtf8(bad)) << bad;
}

TEST(Utf8, otherBytesAreThoseOfLatin1) {
  EXPECT_EQ(asUtf8("H\xfc" "fte"), "Hüfte");
  EXPECT_EQ(asUtf8("Hüfte"), "Hüfte");
  for (int c = 1; c < 256; ++c) {
    const std::string one(1, static_cast<char>(c));
    const std::string text = asUtf8(one + "\xff");
    EXPECT_TRUE(isUtf8(text)) << c;
    EXPECT_EQ(text.size(), c < 128 ? 3u : 4u);
    EXPECT_EQ(asUtf8(text), text);
  }
}

}  // namespace
}  // namespace glenoid
