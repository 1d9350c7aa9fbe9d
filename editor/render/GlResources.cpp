// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/render/GlResources.h"

#include <cmath>

namespace glenoid {
namespace {

Error shaderError(std::string_view name, const std::string& log) {
  return Error{Fault::Internal, {std::string(name), {}, {}, {}}, {}, "shader: " + log};
}

Result<unsigned> compiled(std::string_view name, const std::string& defines) {
  const std::string_view body = embeddedShader(name), common = embeddedShader("common.glsl");
  if (body.empty()) return shaderError(name, "not built in");
  const GLenum stage = name.find(".vert.") != name.npos   ? GL_VERTEX_SHADER
                       : name.find(".geom.") != name.npos ? GL_GEOMETRY_SHADER
                                                          : GL_FRAGMENT_SHADER;
  const std::string head = "#version 330 core\n" + defines;
  const char* parts[] = {head.data(), common.data(), body.data()};
  const int lengths[] = {static_cast<int>(head.size()), static_cast<int>(common.size()),
                         static_cast<int>(body.size())};
  const unsigned id = glCreateShader(stage);
  glShaderSource(id, 3, parts, lengths);
  glCompileShader(id);
  int good = 0;
  glGetShaderiv(id, GL_COMPILE_STATUS, &good);
  if (good) return id;
  std::string log(2000, '\0');
  int length = 0;
  glGetShaderInfoLog(id, static_cast<int>(log.size()), &length, log.data());
  log.resize(length);
  glDeleteShader(id);
  return shaderError(name, log);
}

}  // namespace

Program::~Program() {
  if (m_id != 0) glDeleteProgram(m_id);
}

Result<Program> Program::build(std::initializer_list<std::string_view> shaders, const char* captured,
                               const std::string& defines) {
  Program program;
  program.m_id = glCreateProgram();
  for (const std::string_view name : shaders) {
    auto shader = compiled(name, defines);
    if (!shader) return shader.error();
    glAttachShader(program.m_id, *shader);
    glDeleteShader(*shader);  // goes with the program
  }
  if (captured) glTransformFeedbackVaryings(program.m_id, 1, &captured, GL_INTERLEAVED_ATTRIBS);
  glLinkProgram(program.m_id);
  int good = 0;
  glGetProgramiv(program.m_id, GL_LINK_STATUS, &good);
  if (good) return program;
  std::string log(2000, '\0');
  int length = 0;
  glGetProgramInfoLog(program.m_id, static_cast<int>(log.size()), &length, log.data());
  log.resize(length);
  return shaderError(*shaders.begin(), log);
}

Eigen::Vector3f linearColor(float r, float g, float b) {
  const auto one = [](float c) { return c <= 0.04045f ? c / 12.92f : std::pow((c + 0.055f) / 1.055f, 2.4f); };
  return {one(r), one(g), one(b)};
}

}  // namespace glenoid
