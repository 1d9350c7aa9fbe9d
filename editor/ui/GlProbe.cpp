// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/GlProbe.h"

#include <QGuiApplication>
#include <QOffscreenSurface>
#include <QOpenGLContext>
#include <QSurfaceFormat>

#include "editor/render/GlContext.h"

namespace glenoid {

void prepareGraphics() {
  QSurfaceFormat format;
  format.setVersion(3, 3);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setDepthBufferSize(24);
  format.setStencilBufferSize(8);
  format.setSwapInterval(1);
  QSurfaceFormat::setDefaultFormat(format);
}

GlProbe probeGraphics() {
  GlProbe probe;
  // Qt's "offscreen" platform may give a context, but its QOpenGLWidget crashes when shown.
  const QString platform = QGuiApplication::platformName();
  if (platform == u"offscreen" || platform == u"minimal") return probe;
  QOffscreenSurface surface;
  surface.create();
  QOpenGLContext context;
  if (!surface.isValid() || !context.create() || !context.makeCurrent(&surface)) return probe;
  const GlInfo info = glInfo();
  context.doneCurrent();
  probe.usable = info.usable;
  probe.software = info.software;
  probe.renderer = QString::fromStdString(info.renderer);
  return probe;
}

}  // namespace glenoid
