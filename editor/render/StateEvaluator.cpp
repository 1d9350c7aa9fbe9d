// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/render/StateEvaluator.h"

#include <algorithm>
#include <cstddef>
#include <string>

namespace glenoid {
namespace {

template <class T>
void upload(GlBuffer& buffer, GLenum target, const std::vector<T>& data) {
  const std::size_t bytes = data.size() * sizeof(T);
  glBindBuffer(target, buffer.id());
  // A buffer of no bytes cannot stand behind a texture.
  glBufferData(target, static_cast<GLsizeiptr>(bytes ? bytes : 16), bytes ? data.data() : nullptr,
               GL_STATIC_DRAW);
}

void reserve(GlBuffer& buffer, GLenum target, std::size_t bytes) {
  glBindBuffer(target, buffer.id());
  glBufferData(target, static_cast<GLsizeiptr>(bytes ? bytes : 16), nullptr, GL_DYNAMIC_COPY);
}

void behindTexture(GlTexture& texture, GLenum format, GlBuffer& buffer) {
  glBindTexture(GL_TEXTURE_BUFFER, texture.id());
  glTexBuffer(GL_TEXTURE_BUFFER, format, buffer.id());
}

void floats(int attribute, GlBuffer& buffer, int count) {
  glBindBuffer(GL_ARRAY_BUFFER, buffer.id());
  glEnableVertexAttribArray(attribute);
  glVertexAttribPointer(attribute, count, GL_FLOAT, GL_FALSE, 4 * sizeof(float), nullptr);
}

}  // namespace

Result<Done> StateEvaluator::build() {
  auto positions = Program::build({"positions.vert.glsl"}, "position");
  if (!positions) return positions.error();
  auto normals = Program::build({"normals.vert.glsl"}, "normal");
  if (!normals) return normals.error();
  m_positionPass = std::move(*positions);
  m_normalPass = std::move(*normals);
  m_positionPass.use();
  m_positionPass.set("q", 0);
  m_normalPass.use();
  m_normalPass.set("positions", 0);
  m_normalPass.set("neighbours", 1);
  glUseProgram(0);
  GLint bound = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, m_frame.id());
  glBindRenderbuffer(GL_RENDERBUFFER, m_pixel.id());
  glRenderbufferStorage(GL_RENDERBUFFER, GL_RGBA8, 1, 1);
  glFramebufferRenderbuffer(GL_DRAW_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_RENDERBUFFER, m_pixel.id());
  glBindRenderbuffer(GL_RENDERBUFFER, 0);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<unsigned>(bound));
  return Done{};
}

Result<Done> StateEvaluator::setScene(const SceneGeometry& geometry) {
  GLint limit = 0;
  glGetIntegerv(GL_MAX_TEXTURE_BUFFER_SIZE, &limit);
  for (const std::size_t size :
       {geometry.vertices.size(), geometry.neighbours.size(), static_cast<std::size_t>(geometry.qSize)})
    if (size > static_cast<std::size_t>(limit))
      return Error{Fault::NoGraphics, {}, {}, "scene exceeds buffer textures of " + std::to_string(limit)};

  m_vertexCount = static_cast<int>(geometry.vertices.size());
  m_sent.clear();
  m_field.reset();
  sendShifts({});
  glBindVertexArray(m_surfaces.id());
  glDisableVertexAttribArray(5);  // values of the scene before
  upload(m_entities, GL_ARRAY_BUFFER, geometry.vertices);
  upload(m_rings, GL_ARRAY_BUFFER, geometry.rings);
  upload(m_tissue, GL_ARRAY_BUFFER, geometry.tissue);
  upload(m_neighbours, GL_TEXTURE_BUFFER, geometry.neighbours);
  reserve(m_q, GL_TEXTURE_BUFFER, geometry.qSize * sizeof(float));
  reserve(m_positions, GL_ARRAY_BUFFER, geometry.vertices.size() * 16);
  reserve(m_normals, GL_ARRAY_BUFFER, geometry.vertices.size() * 16);
  behindTexture(m_qTexture, GL_R32F, m_q);
  behindTexture(m_positionTexture, GL_RGBA32F, m_positions);
  behindTexture(m_neighbourTexture, GL_RG32I, m_neighbours);
  glBindTexture(GL_TEXTURE_BUFFER, 0);

  glBindVertexArray(m_entityArray.id());
  glBindBuffer(GL_ARRAY_BUFFER, m_entities.id());
  glEnableVertexAttribArray(0);
  glVertexAttribIPointer(0, 4, GL_INT, sizeof(GpuVertex), nullptr);
  floats(1, m_entities, 4);
  glVertexAttribPointer(1, 4, GL_FLOAT, GL_FALSE, sizeof(GpuVertex),
                        reinterpret_cast<const void*>(offsetof(GpuVertex, weight)));
  glBindVertexArray(m_ringArray.id());
  glBindBuffer(GL_ARRAY_BUFFER, m_rings.id());
  glEnableVertexAttribArray(0);
  glVertexAttribIPointer(0, 2, GL_INT, 0, nullptr);
  glBindVertexArray(m_surfaces.id());
  floats(0, m_positions, 3);
  floats(1, m_normals, 3);
  glBindBuffer(GL_ARRAY_BUFFER, m_tissue.id());
  for (const int attribute : {2, 3}) glEnableVertexAttribArray(attribute);
  glVertexAttribPointer(2, 4, GL_FLOAT, GL_FALSE, sizeof(TissueVertex), nullptr);
  glVertexAttribPointer(3, 3, GL_FLOAT, GL_FALSE, sizeof(TissueVertex),
                        reinterpret_cast<const void*>(offsetof(TissueVertex, across)));
  setOpenness(std::vector<float>(geometry.vertices.size(), 1.0f));
  glBindBuffer(GL_ARRAY_BUFFER, m_openness.id());
  glEnableVertexAttribArray(4);
  glVertexAttribPointer(4, 1, GL_FLOAT, GL_FALSE, 0, nullptr);
  upload(m_indices, GL_ELEMENT_ARRAY_BUFFER, geometry.indices);
  glBindVertexArray(m_points.id());
  floats(0, m_positions, 3);
  glBindBuffer(GL_ELEMENT_ARRAY_BUFFER, m_indices.id());
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
  return Done{};
}

void StateEvaluator::setOpenness(const std::vector<float>& open) {
  upload(m_openness, GL_ARRAY_BUFFER, open);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void StateEvaluator::setField(const std::vector<float>& values) {
  upload(m_field, GL_ARRAY_BUFFER, values);
  glBindVertexArray(m_surfaces.id());
  glEnableVertexAttribArray(5);
  glVertexAttribPointer(5, 1, GL_FLOAT, GL_FALSE, 0, nullptr);
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void StateEvaluator::sendShifts(const std::vector<float>& shifts) {
  m_shifts = shifts;
  glBindVertexArray(m_entityArray.id());
  if (shifts.empty()) {
    glDisableVertexAttribArray(2);
  } else {
    glBindBuffer(GL_ARRAY_BUFFER, m_shift.id());
    glBufferData(GL_ARRAY_BUFFER, static_cast<GLsizeiptr>(shifts.size() * sizeof(float)), shifts.data(), GL_STREAM_DRAW);
    glEnableVertexAttribArray(2);
    glVertexAttribPointer(2, 3, GL_FLOAT, GL_FALSE, 0, nullptr);
  }
  glBindVertexArray(0);
  glBindBuffer(GL_ARRAY_BUFFER, 0);
}

void StateEvaluator::evaluate(const VecX& q, const std::vector<ShownDent>& dents, const std::vector<float>& shifts) {
  if (m_vertexCount == 0) return;
  m_new.resize(q.size());
  for (Eigen::Index i = 0; i < q.size(); ++i) m_new[i] = static_cast<float>(q[i]);
  if (m_new == m_sent && dents == m_dents && shifts == m_shifts) return;
  m_sent.swap(m_new);
  m_dents = dents;
  if (shifts != m_shifts) sendShifts(shifts);
  m_positionPass.use();
  const std::size_t count = std::min(dents.size(), kDentsMost);
  m_positionPass.set("dentCount", static_cast<int>(count));
  for (std::size_t i = 0; i < count; ++i) {
    const std::string at = "[" + std::to_string(i) + "]";
    m_positionPass.set(("dentRange" + at).c_str(), dents[i].vertices.first, dents[i].vertices.first + dents[i].vertices.count);
    m_positionPass.set(("dentPlace" + at).c_str(), dents[i].place_W);
    m_positionPass.set(("dentWay" + at).c_str(), dents[i].way_W);
  }
  const auto bytes = static_cast<GLsizeiptr>(m_sent.size() * sizeof(float));
  glBindBuffer(GL_TEXTURE_BUFFER, m_q.id());
  glBufferData(GL_TEXTURE_BUFFER, bytes, nullptr,
               GL_STREAM_DRAW);  // the frame before may still read the old one
  glBufferSubData(GL_TEXTURE_BUFFER, 0, bytes, m_sent.data());
  glBindBuffer(GL_TEXTURE_BUFFER, 0);

  const auto capture = [this](const Program& program, GlVertexArray& array, GlBuffer& out) {
    program.use();
    glBindVertexArray(array.id());
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, out.id());
    glBeginTransformFeedback(GL_POINTS);
    glDrawArrays(GL_POINTS, 0, m_vertexCount);
    glEndTransformFeedback();
    glBindBufferBase(GL_TRANSFORM_FEEDBACK_BUFFER, 0, 0);
  };
  const auto bind = [](int unit, GlTexture& texture) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_BUFFER, texture.id());
  };
  GLint bound = 0;
  glGetIntegerv(GL_DRAW_FRAMEBUFFER_BINDING, &bound);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, m_frame.id());
  glEnable(GL_RASTERIZER_DISCARD);
  bind(0, m_qTexture);
  capture(m_positionPass, m_entityArray, m_positions);
  bind(1, m_neighbourTexture);
  bind(0, m_positionTexture);
  capture(m_normalPass, m_ringArray, m_normals);
  glDisable(GL_RASTERIZER_DISCARD);
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, static_cast<unsigned>(bound));
  for (const int unit : {1, 0}) {
    glActiveTexture(GL_TEXTURE0 + unit);
    glBindTexture(GL_TEXTURE_BUFFER, 0);
  }
  glBindVertexArray(0);
  glUseProgram(0);
}

std::vector<Eigen::Vector4f> StateEvaluator::read(GlBuffer& buffer, Range range) {
  std::vector<Eigen::Vector4f> out(range.count);
  if (range.count == 0) return out;
  glBindBuffer(GL_COPY_READ_BUFFER, buffer.id());
  glGetBufferSubData(GL_COPY_READ_BUFFER, static_cast<GLintptr>(range.first) * 16,
                     static_cast<GLsizeiptr>(range.count) * 16, out.data());
  glBindBuffer(GL_COPY_READ_BUFFER, 0);
  return out;
}

}  // namespace glenoid
