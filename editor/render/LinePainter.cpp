// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/render/LinePainter.h"

#include <cstddef>

namespace glenoid {
namespace {

constexpr GLuint kColorAttribute = 1;

}  // namespace

Result<Done> LinePainter::build() {
  auto lines = Program::build({"lines.vert.glsl", "lines.geom.glsl", "lines.frag.glsl"});
  if (!lines) return lines.error();
  auto dots = Program::build({"dots.vert.glsl", "dots.frag.glsl"});
  if (!dots) return dots.error();
  m_lineProgram = std::move(*lines);
  m_dotProgram = std::move(*dots);
  glBindVertexArray(m_array.id());
  glBindBuffer(GL_ARRAY_BUFFER, m_buffer.id());
  glEnableVertexAttribArray(0);
  glVertexAttribPointer(0, 3, GL_FLOAT, GL_FALSE, sizeof(ColoredPoint), nullptr);
  glEnableVertexAttribArray(kColorAttribute);
  glVertexAttribPointer(kColorAttribute, 4, GL_FLOAT, GL_FALSE, sizeof(ColoredPoint),
                        reinterpret_cast<const void*>(offsetof(ColoredPoint, color)));
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  return Done{};
}

void LinePainter::begin(const Eigen::Matrix4f& toClip, int widthPx, int heightPx, double depthScale) {
  m_depthScale = static_cast<float>(depthScale);
  m_toClip = toClip;
  m_width = static_cast<float>(widthPx);
  m_height = static_cast<float>(heightPx);
}

void LinePainter::beginPixels(int widthPx, int heightPx) {
  Eigen::Matrix4f toClip = Eigen::Matrix4f::Identity();
  toClip(0, 0) = 2.0f / static_cast<float>(widthPx);
  toClip(1, 1) = 2.0f / static_cast<float>(heightPx);
  toClip(0, 3) = toClip(1, 3) = -1;
  begin(toClip, widthPx, heightPx, 0);
}

void LinePainter::useLines(const Stroke& stroke) {
  m_lineProgram.use();
  m_lineProgram.set("toClip", m_toClip);
  m_lineProgram.set("viewport", m_width, m_height);
  m_lineProgram.set("widthPx", stroke.sizePx);
  m_lineProgram.set("lift", stroke.lift * m_depthScale);
  m_lineProgram.set("strength", stroke.strength);
}

void LinePainter::useDots(const Stroke& stroke) {
  glEnable(GL_PROGRAM_POINT_SIZE);
  m_dotProgram.use();
  m_dotProgram.set("toClip", m_toClip);
  m_dotProgram.set("sizePx", stroke.sizePx);
  m_dotProgram.set("lift", stroke.lift * m_depthScale);
  m_dotProgram.set("strength", stroke.strength);
}

void LinePainter::linesByIndex(unsigned array, Range indices, const Eigen::Vector4f& color,
                               const Stroke& stroke) {
  if (indices.count == 0) return;
  useLines(stroke);
  glBindVertexArray(array);
  glVertexAttrib4fv(kColorAttribute, color.data());
  glDrawElements(
      GL_LINES, indices.count, GL_UNSIGNED_INT,
      reinterpret_cast<const void*>(static_cast<std::size_t>(indices.first) * sizeof(std::uint32_t)));
}

void LinePainter::lines(unsigned array, Range vertices, const Eigen::Vector4f& color, const Stroke& stroke) {
  if (vertices.count == 0) return;
  useLines(stroke);
  glBindVertexArray(array);
  glVertexAttrib4fv(kColorAttribute, color.data());
  glDrawArrays(GL_LINES, vertices.first, vertices.count);
}

void LinePainter::dots(unsigned array, Range vertices, const Eigen::Vector4f& color, const Stroke& stroke) {
  if (vertices.count == 0) return;
  useDots(stroke);
  glBindVertexArray(array);
  glVertexAttrib4fv(kColorAttribute, color.data());
  glDrawArrays(GL_POINTS, vertices.first, vertices.count);
}

void LinePainter::send(const std::vector<ColoredPoint>& points) {
  glBindVertexArray(m_array.id());
  glBindBuffer(GL_ARRAY_BUFFER, m_buffer.id());
  glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(points.size() * sizeof(ColoredPoint)), points.data(),
               GL_STREAM_DRAW);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void LinePainter::lines(const std::vector<ColoredPoint>& points, const Stroke& stroke) {
  if (points.empty()) return;
  useLines(stroke);
  send(points);
  glDrawArrays(GL_LINES, 0, static_cast<GLsizei>(points.size()));
}

void LinePainter::dots(const std::vector<ColoredPoint>& points, const Stroke& stroke) {
  if (points.empty()) return;
  useDots(stroke);
  send(points);
  glDrawArrays(GL_POINTS, 0, static_cast<GLsizei>(points.size()));
}

}  // namespace glenoid
