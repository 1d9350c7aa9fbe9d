// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QString>

namespace glenoid {

/// What can be drawn with on this display.
struct GlProbe {
  bool usable = false;    ///< a window can host the renderer
  bool software = false;  ///< no graphics card: fewer samples, redraw on change only
  QString renderer;       ///< as the driver names itself
};

/// Sets the default surface format (OpenGL 3.3 core, depth and stencil). Before the QApplication is made.
void prepareGraphics();

/// Makes a context off screen and asks it. To be called before the first QOpenGLWidget, which crashes inside Qt
/// where there is no OpenGL.
GlProbe probeGraphics();

}  // namespace glenoid
