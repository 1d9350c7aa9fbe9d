// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <map>
#include <memory>
#include <string>
#include <vector>

#include "editor/render/LabelLayout.h"
#include "editor/render/LinePainter.h"
#include "editor/render/TextRaster.h"

namespace glenoid {

/// Names over a finished picture, each on a plate of its own with a line to what it names.
class LabelPainter {
 public:
  struct Label {
    std::string text;              ///< UTF-8
    Vec2 anchor = Vec2::Zero();    ///< pixels of the target from the upper left
  };

  Result<Done> build();
  /// Into the bound target, which is as large as the area; blends, leaves depth test off. Of the area margin and gap
  /// are set here. `dark`: of the background.
  void draw(const std::vector<Label>& labels, const LabelArea& area, double pixelRatio, bool dark,
            LinePainter& lines);
  /// One line of text alone, without a plate, its upper left corner at `at` (pixels from the upper left, rounded).
  void text(const std::string& words, const Vec2& at, double sizePx, const Eigen::Vector3f& ink, int widthPx, int heightPx);
  /// Width and height of such a line, pixels; zero without any font.
  Vec2 sizeOf(const std::string& words, double sizePx);

 private:
  struct Plate {
    GlTexture texture;
    int width = 0, height = 0;
  };
  void put(Plate& plate, const Vec2& lowerLeft, const Vec2& size, const Vec2& pad);
  void begin(const Eigen::Vector3f& ink, const Eigen::Vector3f& paper, float opacity, int widthPx, int heightPx);
  Plate& plateOf(const std::string& text, double sizePx);

  Program m_program;
  GlVertexArray m_array;
  std::unique_ptr<TextRaster> m_raster;  ///< made at first use: looking for fonts takes a moment
  std::map<std::pair<std::string, int>, Plate> m_plates;
};

}  // namespace glenoid
