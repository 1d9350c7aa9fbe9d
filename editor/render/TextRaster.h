// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace glenoid {

/// One line of text as shares of ink, row by row from the top.
struct TextPicture {
  int width = 0, height = 0;
  std::vector<std::uint8_t> ink;  ///< 0…255, width × height
};

/// Draws single lines with the system's sans-serif font, left to right, with kerning; no OpenGL here. Without any font
/// every text is an empty picture. One thread at a time.
class TextRaster {
 public:
  TextRaster();
  ~TextRaster();
  TextRaster(const TextRaster&) = delete;
  TextRaster& operator=(const TextRaster&) = delete;

  bool hasFont() const;
  /// `utf8`: what is no UTF-8 is shown as the font's missing character. sizePx: of the em, 4…200.
  TextPicture line(const std::string& utf8, double sizePx);

 private:
  struct Font;
  std::unique_ptr<Font> m_font;
};

}  // namespace glenoid
