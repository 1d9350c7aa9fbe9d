// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/render/TextRaster.h"

#include <fontconfig/fontconfig.h>
#include <ft2build.h>
#include FT_FREETYPE_H

#include <algorithm>
#include <cmath>

namespace glenoid {
namespace {

/// File of the best match for "sans"; empty without any font.
std::string sansFile() {
  FcConfig* config = FcInitLoadConfigAndFonts();
  if (!config) return {};
  FcPattern* wish = FcNameParse(reinterpret_cast<const FcChar8*>("DejaVu Sans,sans"));
  FcConfigSubstitute(config, wish, FcMatchPattern);
  FcDefaultSubstitute(wish);
  FcResult result = FcResultNoMatch;
  std::string file;
  if (FcPattern* match = FcFontMatch(config, wish, &result)) {
    FcChar8* name = nullptr;
    if (FcPatternGetString(match, FC_FILE, 0, &name) == FcResultMatch) file = reinterpret_cast<const char*>(name);
    FcPatternDestroy(match);
  }
  FcPatternDestroy(wish);
  FcConfigDestroy(config);
  return file;
}

/// The character at `at`, which goes on to the next; U+FFFD for what is none.
char32_t nextCharacter(const std::string& text, std::size_t& at) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char first = byte(at++);
  if (first < 0x80) return first;
  const int more = first >= 0xf0 && first < 0xf8 ? 3 : first >= 0xe0 && first < 0xf0 ? 2 : first >= 0xc0 && first < 0xe0 ? 1 : 0;
  if (more == 0) return 0xfffd;
  char32_t code = first & (0x3f >> more);
  for (int i = 0; i < more; ++i) {
    if (at >= text.size() || (byte(at) & 0xc0) != 0x80) return 0xfffd;
    code = code << 6 | (byte(at++) & 0x3f);
  }
  return code;
}

}  // namespace

struct TextRaster::Font {
  FT_Library library = nullptr;
  FT_Face face = nullptr;
  ~Font() {
    if (face) FT_Done_Face(face);
    if (library) FT_Done_FreeType(library);
  }
};

TextRaster::TextRaster() : m_font(std::make_unique<Font>()) {
  if (FT_Init_FreeType(&m_font->library) != 0) return;
  const std::string file = sansFile();
  if (!file.empty() && FT_New_Face(m_font->library, file.c_str(), 0, &m_font->face) != 0) m_font->face = nullptr;
}

TextRaster::~TextRaster() = default;

bool TextRaster::hasFont() const { return m_font->face != nullptr; }

TextPicture TextRaster::line(const std::string& utf8, double sizePx) {
  TextPicture picture;
  FT_Face face = m_font->face;
  if (!face || FT_Set_Char_Size(face, 0, static_cast<FT_F26Dot6>(64 * std::clamp(sizePx, 4.0, 200.0)), 72, 72) != 0) return picture;
  const int ascent = static_cast<int>(face->size->metrics.ascender >> 6), descent = static_cast<int>(-face->size->metrics.descender >> 6);
  for (const bool draw : {false, true}) {  // first how wide it is
    FT_Pos pen = 0;
    FT_UInt before = 0;
    for (std::size_t at = 0; at < utf8.size();) {
      const FT_UInt glyph = FT_Get_Char_Index(face, nextCharacter(utf8, at));
      FT_Vector kern{0, 0};
      if (before && FT_HAS_KERNING(face)) FT_Get_Kerning(face, before, glyph, FT_KERNING_DEFAULT, &kern);
      pen += kern.x;
      before = glyph;
      if (FT_Load_Glyph(face, glyph, draw ? FT_LOAD_RENDER : FT_LOAD_DEFAULT) != 0) continue;
      const FT_GlyphSlot slot = face->glyph;
      if (draw) {
        const int left = static_cast<int>(pen >> 6) + slot->bitmap_left, top = ascent - slot->bitmap_top;
        for (unsigned y = 0; y < slot->bitmap.rows; ++y)
          for (unsigned x = 0; x < slot->bitmap.width; ++x) {
            const int px = left + static_cast<int>(x), py = top + static_cast<int>(y);
            if (px < 0 || py < 0 || px >= picture.width || py >= picture.height) continue;
            std::uint8_t& ink = picture.ink[static_cast<std::size_t>(py) * picture.width + px];
            ink = std::max(ink, slot->bitmap.buffer[y * slot->bitmap.pitch + x]);
          }
      }
      pen += slot->advance.x;
    }
    if (draw) break;
    picture.width = static_cast<int>((pen + 63) >> 6) + 1;
    picture.height = ascent + descent;
    picture.ink.assign(static_cast<std::size_t>(picture.width) * picture.height, 0);
  }
  return picture;
}

}  // namespace glenoid
