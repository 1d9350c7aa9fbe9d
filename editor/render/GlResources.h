// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <epoxy/gl.h>

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>

#include "simcore/base/Error.h"
#include "simcore/base/Math.h"

/// Owners of OpenGL names, private to this folder (epoxy's header does not go with Qt's). All need the
/// context current.
namespace glenoid {

/// Text of a shader in resources/shaders, built into the library; empty when there is none of this name.
std::string_view embeddedShader(std::string_view name);

/// A name that is freed with its owner. Kind tells how.
template <class Kind>
class GlName {
 public:
  GlName() = default;
  ~GlName() { reset(); }
  GlName(GlName&& other) noexcept : m_id(std::exchange(other.m_id, 0)) {}
  GlName& operator=(GlName&& other) noexcept {
    std::swap(m_id, other.m_id);
    return *this;
  }
  unsigned id() {  ///< made at first use
    if (m_id == 0) m_id = Kind::make();
    return m_id;
  }
  void reset() {
    if (m_id != 0) Kind::free(m_id);
    m_id = 0;
  }

 private:
  unsigned m_id = 0;
};

struct BufferKind {
  static unsigned make() {
    unsigned id = 0;
    glGenBuffers(1, &id);
    return id;
  }
  static void free(unsigned id) { glDeleteBuffers(1, &id); }
};
struct TextureKind {
  static unsigned make() {
    unsigned id = 0;
    glGenTextures(1, &id);
    return id;
  }
  static void free(unsigned id) { glDeleteTextures(1, &id); }
};
struct RenderbufferKind {
  static unsigned make() {
    unsigned id = 0;
    glGenRenderbuffers(1, &id);
    return id;
  }
  static void free(unsigned id) { glDeleteRenderbuffers(1, &id); }
};
struct FramebufferKind {
  static unsigned make() {
    unsigned id = 0;
    glGenFramebuffers(1, &id);
    return id;
  }
  static void free(unsigned id) { glDeleteFramebuffers(1, &id); }
};
struct VertexArrayKind {
  static unsigned make() {
    unsigned id = 0;
    glGenVertexArrays(1, &id);
    return id;
  }
  static void free(unsigned id) { glDeleteVertexArrays(1, &id); }
};
using GlBuffer = GlName<BufferKind>;
using GlTexture = GlName<TextureKind>;
using GlRenderbuffer = GlName<RenderbufferKind>;
using GlFramebuffer = GlName<FramebufferKind>;
using GlVertexArray = GlName<VertexArrayKind>;

/// A linked program. Uniforms that a driver has optimised away are set without complaint.
class Program {
 public:
  Program() = default;
  ~Program();
  Program(Program&& other) noexcept : m_id(std::exchange(other.m_id, 0)) {}
  Program& operator=(Program&& other) noexcept {
    std::swap(m_id, other.m_id);
    return *this;
  }

  /// From embedded shaders, the stage told by the middle ending (vert, geom, frag). With `captured`, that
  /// output of the vertex stage goes to transform feedback. `defines`: lines put in front of each shader.
  /// Fails with Internal; detail is the driver's log.
  static Result<Program> build(std::initializer_list<std::string_view> shaders,
                               const char* captured = nullptr, const std::string& defines = {});

  void use() const { glUseProgram(m_id); }
  void set(const char* name, int value) const { glUniform1i(at(name), value); }
  void set(const char* name, float value) const { glUniform1f(at(name), value); }
  void set(const char* name, int x, int y) const { glUniform2i(at(name), x, y); }
  void set(const char* name, float x, float y) const { glUniform2f(at(name), x, y); }
  void set(const char* name, const Eigen::Vector3f& v) const { glUniform3fv(at(name), 1, v.data()); }
  void set(const char* name, const Eigen::Vector4f& v) const { glUniform4fv(at(name), 1, v.data()); }
  void set(const char* name, const Eigen::Matrix4f& m) const {
    glUniformMatrix4fv(at(name), 1, GL_FALSE, m.data());
  }

 private:
  int at(const char* name) const { return glGetUniformLocation(m_id, name); }
  unsigned m_id = 0;
};

/// sRGB 0…1 → linear.
Eigen::Vector3f linearColor(float r, float g, float b);

}  // namespace glenoid
