// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <string>

#include "simcore/base/Error.h"

namespace glenoid {

/// An OpenGL 3.3+ core context with no window, no display server and no default framebuffer (EGL platform
/// "surfaceless"; Mesa's llvmpipe will do). Current on at most one thread at a time; not for a thread on
/// which a window system's context is current. Wrong for a window: there the toolkit's own context hosts the
/// renderer. Source: Khronos registry, EGL_MESA_platform_surfaceless and EGL_KHR_surfaceless_context.
class HeadlessContext {
 public:
  /// A new context, current on this thread. Fails with Fault::NoGraphics.
  static Result<std::unique_ptr<HeadlessContext>> create();
  ~HeadlessContext();
  HeadlessContext(const HeadlessContext&) = delete;
  HeadlessContext& operator=(const HeadlessContext&) = delete;

  /// Fails with Fault::NoGraphics when the driver refuses (context current on another thread).
  Result<Done> makeCurrent();
  /// Leaves this thread without a current context, so that another thread may take this one.
  void doneCurrent();

 private:
  HeadlessContext() = default;
  void* m_display = nullptr;  ///< EGLDisplay; shared by the process, never terminated here
  void* m_context = nullptr;  ///< EGLContext, owned
};

/// What draws. Asks the context that is current on this thread.
struct GlInfo {
  std::string renderer, version;  ///< as the driver names itself
  bool software = false;          ///< llvmpipe or softpipe: no MSAA, redraw on change only
  bool usable = false;            ///< at least 3.3
};
GlInfo glInfo();

}  // namespace glenoid
