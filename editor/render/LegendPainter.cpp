// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/render/LegendPainter.h"

#include <algorithm>
#include <cmath>

#include "editor/render/SceneRenderer.h"

namespace glenoid {
namespace {
constexpr double kTextPx = 13, kBarPx = 16, kBarMostPx = 200, kBarLeastPx = 60;  ///< at a pixel ratio of one
}  // namespace

Result<Done> LegendPainter::build() {
  auto program = Program::build({"label.vert.glsl", "legend.frag.glsl"});
  if (!program) return program.error();
  m_program = std::move(*program);
  return Done{};
}

LegendBox LegendPainter::draw(const FieldLook& field, const Target& target, unsigned scale, double pixelRatio, bool dark,
                              LabelPainter& words, LinePainter& lines) {
  if (field.title.empty() || !(field.high > field.low)) return {};
  const double unit = std::max(pixelRatio, 0.1), text = kTextPx * unit, pad = std::round(8 * unit), tick = std::round(5 * unit);
  const double bar = std::round(kBarPx * unit), tall = std::round(std::min(kBarMostPx * unit, 0.38 * target.height)), margin = std::round(10 * unit);
  const Vec2 title = words.sizeOf(field.title, text);
  double widest = 0, line = title.y();
  for (const FieldLook::Tick& each : field.ticks) {
    const Vec2 size = words.sizeOf(each.text, text);
    widest = std::max(widest, size.x());
    line = std::max(line, size.y());
  }
  const double width = std::max(title.x(), bar + 2 * tick + widest) + 2 * pad;
  const double height = pad + title.y() + std::round(0.5 * line) + pad / 2 + tall + std::round(0.5 * line) + pad / 2;
  if (tall < kBarLeastPx * unit || width + margin > target.width || height + margin > target.height) return {};

  const double left = target.width - margin - width, top = target.height - margin - height;  // from the upper left
  const double barLow = pad / 2 + std::round(0.5 * line);                                    // from the plate's lower left
  const Eigen::Vector3f ink = dark ? Eigen::Vector3f(0.93f, 0.94f, 0.95f) : Eigen::Vector3f(0.10f, 0.12f, 0.15f);
  const Eigen::Vector3f paper = dark ? Eigen::Vector3f(0.11f, 0.12f, 0.14f) : Eigen::Vector3f(1, 1, 1);
  glDisable(GL_DEPTH_TEST);
  glEnable(GL_BLEND);
  glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
  m_program.use();
  const auto set = [&](const char* name, double x, double y) { m_program.set(name, static_cast<float>(x), static_cast<float>(y)); };
  set("corner", left, margin);
  set("size", width, height);
  set("viewport", target.width, target.height);
  set("barFrom", pad, barLow);
  set("barTo", pad + bar, barLow + tall);
  m_program.set("frame", static_cast<float>(std::max(1.0, std::round(unit))));
  m_program.set("ink", ink);
  m_program.set("paper", paper);
  m_program.set("scale", 0);
  glActiveTexture(GL_TEXTURE0);
  glBindTexture(GL_TEXTURE_1D, scale);
  glBindVertexArray(m_array.id());
  glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
  glBindTexture(GL_TEXTURE_1D, 0);

  // Pixels from the lower left, as OpenGL counts.
  std::vector<ColoredPoint> strokes;
  std::vector<std::pair<double, const FieldLook::Tick*>> shown;
  double last = -1e9;
  for (const FieldLook::Tick& each : field.ticks) {
    const double share = (each.at - field.low) / (field.high - field.low);
    if (share < -1e-9 || share > 1 + 1e-9) continue;
    const double up = margin + barLow + share * tall;
    if (up - last < line) continue;  // no room between two
    last = up;
    shown.push_back({up, &each});
    const Eigen::Vector4f color(ink.x(), ink.y(), ink.z(), 1);
    for (const double x : {left + pad + bar, left + pad + bar + tick}) strokes.push_back({Eigen::Vector3f(float(x), float(up), 0), color});
  }
  lines.beginPixels(target.width, target.height);
  glEnable(GL_BLEND);
  lines.lines(strokes, {static_cast<float>(1.2 * unit), 0, 1});
  words.text(field.title, {left + pad, top + pad / 2}, text, ink, target.width, target.height);
  for (const auto& [up, each] : shown)
    words.text(each->text, {left + pad + bar + 2 * tick, target.height - up - 0.5 * line}, text, ink, target.width, target.height);
  glBindVertexArray(0);
  glDisable(GL_BLEND);
  return {width + margin, height + margin};
}

}  // namespace glenoid
