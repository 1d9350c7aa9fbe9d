// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/render/GlContext.h"

#include <epoxy/egl.h>
#include <epoxy/gl.h>

namespace glenoid {
namespace {

Error noGraphics(const char* what) {
  Error error{Fault::NoGraphics, {}, {}, what};
  error.detail += ", EGL status " + std::to_string(eglGetError());
  return error;
}

}  // namespace

Result<std::unique_ptr<HeadlessContext>> HeadlessContext::create() {
  // Without a display epoxy answers for client extensions only; an EGL older than 1.5 without them answers
  // false.
  if (!epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_EXT_platform_base") ||
      !epoxy_has_egl_extension(EGL_NO_DISPLAY, "EGL_MESA_platform_surfaceless"))
    return noGraphics("EGL offers no surfaceless platform");
  const EGLDisplay display =
      eglGetPlatformDisplayEXT(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
  if (display == EGL_NO_DISPLAY) return noGraphics("no surfaceless display");
  if (!eglInitialize(display, nullptr, nullptr)) return noGraphics("the surfaceless display does not start");
  if (!eglBindAPI(EGL_OPENGL_API)) return noGraphics("EGL offers no desktop OpenGL");
  const EGLint wanted[] = {EGL_SURFACE_TYPE, 0, EGL_RENDERABLE_TYPE, EGL_OPENGL_BIT, EGL_NONE};
  EGLConfig config = nullptr;
  EGLint found = 0;
  if (!eglChooseConfig(display, wanted, &config, 1, &found) || found < 1)
    return noGraphics("no EGL configuration");
  const EGLint attributes[] = {EGL_CONTEXT_MAJOR_VERSION,
                               3,
                               EGL_CONTEXT_MINOR_VERSION,
                               3,
                               EGL_CONTEXT_OPENGL_PROFILE_MASK,
                               EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                               EGL_NONE};
  const EGLContext context = eglCreateContext(display, config, EGL_NO_CONTEXT, attributes);
  if (context == EGL_NO_CONTEXT) return noGraphics("no OpenGL 3.3 core context");

  std::unique_ptr<HeadlessContext> made(new HeadlessContext);
  made->m_display = display;
  made->m_context = context;
  if (auto current = made->makeCurrent(); !current) return current.error();
  if (!glInfo().usable) return noGraphics("OpenGL is older than 3.3");
  return made;
}

HeadlessContext::~HeadlessContext() {
  if (!m_context) return;
  if (eglGetCurrentContext() == m_context) doneCurrent();
  eglDestroyContext(m_display, m_context);
}

Result<Done> HeadlessContext::makeCurrent() {
  eglBindAPI(EGL_OPENGL_API);  // a setting of the thread
  if (!eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, m_context))
    return noGraphics("the context cannot be made current without a surface");
  return Done{};
}

void HeadlessContext::doneCurrent() {
  eglMakeCurrent(m_display, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
}

GlInfo glInfo() {
  GlInfo info;
  const auto text = [](GLenum name) {
    const auto* s = reinterpret_cast<const char*>(glGetString(name));
    return std::string(s ? s : "");
  };
  info.renderer = text(GL_RENDERER);
  info.version = text(GL_VERSION);
  info.usable = !info.version.empty() && epoxy_is_desktop_gl() && epoxy_gl_version() >= 33;
  for (const char* name : {"llvmpipe", "softpipe", "SWR", "Software Rasterizer"})
    info.software = info.software || info.renderer.find(name) != std::string::npos;
  return info;
}

}  // namespace glenoid
