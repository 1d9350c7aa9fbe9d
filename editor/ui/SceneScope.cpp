// SPDX-License-Identifier: GPL-3.0-or-later
// The view's second picture: through the arthroscope, large or in a corner, with the outside in the other place.
#include <QOpenGLContext>
#include <QOpenGLFramebufferObject>
#include <QOpenGLFunctions>
#include <algorithm>
#include <cmath>

#include "editor/ui/SceneView.h"

namespace glenoid {

namespace {

constexpr double kInsetShare = 0.34;  ///< of the view's smaller side
constexpr int kInsetMargin = 10;      ///< logical pixels

}  // namespace

std::optional<int> SceneView::scopeObject() const {
  if (!m_model) return std::nullopt;
  const auto& tools = m_model->scenario.tools;
  if (m_chosenTool >= 0 && m_chosenTool < static_cast<int>(tools.size()))
    if (const auto chosen = findScope(*m_model, tools[m_chosenTool].id)) return chosen;
  return findScope(*m_model);
}

void SceneView::setScope(ScopePlace place) {
  if (place == m_scope) return;
  m_scope = place;
  endGesture();
  emit scopeChanged();
  requestDraw();
}

bool SceneView::scopeIsLarge() const { return m_scope == ScopePlace::Large && !isAuthoring() && scopeObject(); }

View SceneView::shownView() {
  if (!scopeIsLarge()) return m_view;
  return scopeSight(*m_model, shownState(), *scopeObject(), std::max(width(), 1), std::max(height(), 1)).view;
}

void SceneView::drawInto(const Target& target, bool through, const Look& look) {
  const Snapshot& snapshot = m_link.snapshot();
  Layers shown = layers();
  if (!through) {
    if (target.width < 400) shown.labels = false;  // of a corner's picture they would cover all
    m_renderer->draw(m_view, shownState(), shown, snapshot.report.contactViews, look, target);
    return;
  }
  const int object = *scopeObject();
  const ScopeSight sight = scopeSight(*m_model, shownState(), object, target.width, target.height);
  Look scoped = look;
  scoped.scope = sight.look;
  m_renderer->draw(sight.view, shownState(), throughScope(std::move(shown), object), snapshot.report.contactViews, scoped, target);
}

void SceneView::drawInset(const Look& look) {
  if (m_scope == ScopePlace::Off || isAuthoring() || !scopeObject()) return;
  const Target full = target();
  const double ratio = devicePixelRatioF();
  const int side = static_cast<int>(std::lround(kInsetShare * std::min(full.width, full.height)));
  if (side < 64) return;
  const bool through = m_scope == ScopePlace::Small;
  const QSize size(through ? side : side * 4 / 3, side);
  if (!m_inset || m_inset->size() != size) m_inset = std::make_unique<QOpenGLFramebufferObject>(size, QOpenGLFramebufferObject::CombinedDepthStencil);
  drawInto({m_inset->handle(), size.width(), size.height()}, through, look);
  const int margin = static_cast<int>(std::lround(kInsetMargin * ratio));
  // OpenGL counts rows from below: the lower right corner.
  QOpenGLFramebufferObject::blitFramebuffer(nullptr, QRect(full.width - margin - size.width(), margin, size.width(), size.height()), m_inset.get(),
                                            QRect(QPoint(0, 0), size), GL_COLOR_BUFFER_BIT, GL_NEAREST);
  context()->functions()->glBindFramebuffer(GL_FRAMEBUFFER, full.framebuffer);
}

}  // namespace glenoid
