// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/render/FrameBuffers.h"

namespace glenoid {
namespace {

void makeTexture(GlTexture& texture, GLenum internal, GLenum format, GLenum type, int width, int height) {
  glBindTexture(GL_TEXTURE_2D, texture.id());
  glTexImage2D(GL_TEXTURE_2D, 0, static_cast<GLint>(internal), width, height, 0, format, type, nullptr);
  for (const GLenum filter : {GL_TEXTURE_MIN_FILTER, GL_TEXTURE_MAG_FILTER})
    glTexParameteri(GL_TEXTURE_2D, filter, GL_NEAREST);
  for (const GLenum wrap : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T})
    glTexParameteri(GL_TEXTURE_2D, wrap, GL_CLAMP_TO_EDGE);
  glBindTexture(GL_TEXTURE_2D, 0);
}

void makeStore(GlRenderbuffer& store, GLenum format, int width, int height, int samples, GLenum attachment) {
  glBindRenderbuffer(GL_RENDERBUFFER, store.id());
  if (samples > 1) {
    glRenderbufferStorageMultisample(GL_RENDERBUFFER, samples, format, width, height);
  } else {
    glRenderbufferStorage(GL_RENDERBUFFER, format, width, height);
  }
  glFramebufferRenderbuffer(GL_FRAMEBUFFER, attachment, GL_RENDERBUFFER, store.id());
  glBindRenderbuffer(GL_RENDERBUFFER, 0);
}

bool complete() {
  return glCheckFramebufferStatus(GL_FRAMEBUFFER) == GL_FRAMEBUFFER_COMPLETE;
}

bool makeSingle(GlFramebuffer& frame, GlTexture& texture, GLenum internal, GLenum format, GLenum type,
                int width, int height) {
  makeTexture(texture, internal, format, type, width, height);
  glBindFramebuffer(GL_FRAMEBUFFER, frame.id());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture.id(), 0);
  return complete();
}

}  // namespace

bool FrameBuffers::resize(int width, int height, int factor, int samples) {
  if (width == m_width && height == m_height && factor == m_factor && samples == m_samples) return true;
  const int w = width * factor, h = height * factor;
  m_width = m_height = m_factor = m_samples = 0;  // until it has succeeded
  makeTexture(m_color, GL_RGBA16F, GL_RGBA, GL_HALF_FLOAT, w, h);
  makeTexture(m_depth, GL_DEPTH_COMPONENT32F, GL_DEPTH_COMPONENT, GL_FLOAT, w, h);
  glBindFramebuffer(GL_FRAMEBUFFER, m_resolved.id());
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, m_color.id(), 0);
  glFramebufferTexture2D(GL_FRAMEBUFFER, GL_DEPTH_ATTACHMENT, GL_TEXTURE_2D, m_depth.id(), 0);
  bool good = complete();
  if (samples > 1) {
    glBindFramebuffer(GL_FRAMEBUFFER, m_many.id());
    makeStore(m_manyColor, GL_RGBA16F, w, h, samples, GL_COLOR_ATTACHMENT0);
    makeStore(m_manyDepth, GL_DEPTH_COMPONENT32F, w, h, samples, GL_DEPTH_ATTACHMENT);
    good = good && complete();
  }
  good = makeSingle(m_maskFrame, m_mask, GL_R8, GL_RED, GL_UNSIGNED_BYTE, width, height) && good;
  if (!good) return false;
  m_width = width, m_height = height, m_factor = factor, m_samples = samples;
  return true;
}

void FrameBuffers::bindScene() {
  glBindFramebuffer(GL_FRAMEBUFFER, m_samples > 1 ? m_many.id() : m_resolved.id());
  glViewport(0, 0, m_width * m_factor, m_height * m_factor);
  const float nothing[4] = {0, 0, 0, 0}, farthest = 1;
  glClearBufferfv(GL_COLOR, 0, nothing);
  glClearBufferfv(GL_DEPTH, 0, &farthest);
}

void FrameBuffers::resolveScene() {
  if (m_samples <= 1) return;
  const int w = m_width * m_factor, h = m_height * m_factor;
  glBindFramebuffer(GL_READ_FRAMEBUFFER, m_many.id());
  glBindFramebuffer(GL_DRAW_FRAMEBUFFER, m_resolved.id());
  glBlitFramebuffer(0, 0, w, h, 0, 0, w, h, GL_COLOR_BUFFER_BIT | GL_DEPTH_BUFFER_BIT, GL_NEAREST);
}

void FrameBuffers::bindMask() {
  glBindFramebuffer(GL_FRAMEBUFFER, m_maskFrame.id());
  glViewport(0, 0, m_width, m_height);
  const float nothing[4] = {0, 0, 0, 0};
  glClearBufferfv(GL_COLOR, 0, nothing);
}

bool ReadableTarget::resize(int width, int height) {
  glBindFramebuffer(GL_FRAMEBUFFER, m_frame.id());
  makeStore(m_color, GL_RGBA8, width, height, 1, GL_COLOR_ATTACHMENT0);
  return complete();
}

bool PickTarget::resize(int width, int height) {
  if (width == m_width && height == m_height) return true;
  m_width = m_height = 0;
  glBindFramebuffer(GL_FRAMEBUFFER, m_frame.id());
  makeStore(m_what, GL_RGBA32I, width, height, 1, GL_COLOR_ATTACHMENT0);
  makeStore(m_where, GL_RGBA32F, width, height, 1, GL_COLOR_ATTACHMENT1);
  makeStore(m_normal, GL_RGBA32F, width, height, 1, GL_COLOR_ATTACHMENT2);
  makeStore(m_depth, GL_DEPTH_COMPONENT32F, width, height, 1, GL_DEPTH_ATTACHMENT);
  const GLenum all[] = {GL_COLOR_ATTACHMENT0, GL_COLOR_ATTACHMENT1, GL_COLOR_ATTACHMENT2};
  glDrawBuffers(3, all);
  if (!complete()) return false;
  m_width = width, m_height = height;
  return true;
}

void PickTarget::bind() {
  glBindFramebuffer(GL_FRAMEBUFFER, m_frame.id());
  const GLint nothing[4] = {0, 0, 0, 0};
  const float zero[4] = {0, 0, 0, 0}, farthest = 1;
  glClearBufferiv(GL_COLOR, 0, nothing);
  glClearBufferfv(GL_COLOR, 1, zero);
  glClearBufferfv(GL_COLOR, 2, zero);
  glClearBufferfv(GL_DEPTH, 0, &farthest);
}

}  // namespace glenoid
