// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/render/LabelPainter.h"

#include <cmath>

namespace glenoid {
namespace {
constexpr double kTextPx = 13;   ///< at a pixel ratio of one
constexpr std::size_t kPlatesMost = 500;  ///< kept; a scene has some dozens
}  // namespace

Result<Done> LabelPainter::build() {
  auto program = Program::build({"label.vert.glsl", "label.frag.glsl"});
  if (!program) return program.error();
  m_program = std::move(*program);
  return Done{};
}

LabelPainter::Plate& LabelPainter::plateOf(const std::string& text, double sizePx) {
  if (!m_raster) m_raster = std::make_unique<TextRaster>();
  if (m_plates.size() > kPlatesMost) m_plates.clear();
  Plate& plate = m_plates[{text, static_cast<int>(std::lround(16 * sizePx))}];
  if (plate.width > 0) return plate;
  const TextPicture picture = m_raster->line(text, sizePx);
  plate.width = picture.width;
  plate.height = picture.height;
  if (picture.width == 0) return plate;
  glBindTexture(GL_TEXTURE_2D, plate.texture.id());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 1);
  glTexImage2D(GL_TEXTURE_2D, 0, GL_R8, picture.width, picture.height, 0, GL_RED, GL_UNSIGNED_BYTE, picture.ink.data());
  glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
  glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MAG_FILTER, GL_NEAREST);
  glBindTexture(GL_TEXTURE_2D, 0);
  return plate;
}

void LabelPainter::begin(const Eigen::Vector3f& ink, const Eigen::Vector3f& paper, float opacity, int widthPx, int heightPx) {
  m_program.use();
  m_program.set("ink", ink);
  m_program.set("paper", paper);
  m_program.set("plateOpacity", opacity);
  m_program.set("text", 0);
  m_program.set("viewport", static_cast<float>(widthPx), static_cast<float>(heightPx));
  glBindVertexArray(m_array.id());
  glActiveTexture(GL_TEXTURE0);
}

void LabelPainter::put(Plate& plate, const Vec2& lowerLeft, const Vec2& size, const Vec2& pad) {
  glBindTexture(GL_TEXTURE_2D, plate.texture.id());
  m_program.set("corner", static_cast<float>(lowerLeft.x()), static_cast<float>(lowerLeft.y()));
  m_program.set("size", static_cast<float>(size.x()), static_cast<float>(size.y()));
  m_program.set("pad", static_cast<float>(pad.x()), static_cast<float>(pad.y()));
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

Vec2 LabelPainter::sizeOf(const std::string& words, double sizePx) {
  const Plate& plate = plateOf(words, sizePx);
  return {static_cast<double>(plate.width), static_cast<double>(plate.height)};
}

void LabelPainter::text(const std::string& words, const Vec2& at, double sizePx, const Eigen::Vector3f& ink, int widthPx, int heightPx) {
  Plate& plate = plateOf(words, sizePx);
  if (plate.width == 0) return;
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  begin(ink, ink, 0, widthPx, heightPx);
  put(plate, {std::round(at.x()), heightPx - std::round(at.y()) - plate.height}, {static_cast<double>(plate.width), static_cast<double>(plate.height)},
      Vec2::Zero());
  glBindTexture(GL_TEXTURE_2D, 0);
  glBindVertexArray(0);
  glDisable(GL_BLEND);
}

void LabelPainter::draw(const std::vector<Label>& labels, const LabelArea& target, double pixelRatio, bool dark,
                        LinePainter& lines) {
  const int widthPx = static_cast<int>(target.width), heightPx = static_cast<int>(target.height);
  const double scale = std::max(pixelRatio, 0.1), pad = std::round(4 * scale);
  std::vector<LabelWish> wishes;
  for (const Label& label : labels) {
    const Plate& plate = plateOf(label.text, kTextPx * scale);
    wishes.push_back({label.anchor, plate.width > 0 ? plate.width + 2 * pad : 0.0, plate.height + pad});
  }
  LabelArea area = target;
  area.margin = std::round(10 * scale);
  area.gap = std::round(4 * scale);
  const std::vector<LabelPlace> places = layOutLabels(wishes, area);

  // Pixels from the lower left, as OpenGL counts.
  const auto point = [&](const Vec2& p) { return Eigen::Vector3f(float(p.x()), float(heightPx - p.y()), 0); };
  const Eigen::Vector3f ink = dark ? Eigen::Vector3f(0.93f, 0.94f, 0.95f) : Eigen::Vector3f(0.10f, 0.12f, 0.15f);
  const Eigen::Vector3f paper = dark ? Eigen::Vector3f(0.11f, 0.12f, 0.14f) : Eigen::Vector3f(1, 1, 1);
  std::vector<ColoredPoint> leaders, ends;
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (!places[i].placed) continue;
    const Eigen::Vector4f color(ink.x(), ink.y(), ink.z(), 0.85f);
    leaders.push_back({point(labels[i].anchor), color});
    leaders.push_back({point(places[i].lineEnd), color});
    ends.push_back({point(labels[i].anchor), color});
  }
  Eigen::Matrix4f pixels = Eigen::Matrix4f::Identity();
  pixels(0, 0) = 2.0f / static_cast<float>(widthPx);
  pixels(1, 1) = 2.0f / static_cast<float>(heightPx);
  pixels(0, 3) = pixels(1, 3) = -1;
  lines.begin(pixels, widthPx, heightPx, 0);
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  lines.lines(leaders, {static_cast<float>(1.1 * scale), 0, 1});
  lines.dots(ends, {static_cast<float>(4 * scale), 0, 1});

  begin(ink, paper, 0.78f, widthPx, heightPx);
  for (std::size_t i = 0; i < labels.size(); ++i) {
    if (!places[i].placed) continue;
    put(plateOf(labels[i].text, kTextPx * scale),
        {std::round(places[i].corner.x()), heightPx - std::round(places[i].corner.y() + wishes[i].height)},
        {wishes[i].width, wishes[i].height}, {pad, std::round(pad / 2)});
  }
  glBindTexture(GL_TEXTURE_2D, 0);
  glBindVertexArray(0);
  glDisable(GL_BLEND);
}

}  // namespace glenoid
