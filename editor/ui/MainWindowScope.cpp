// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/MainWindow.h"

namespace glenoid {

/// Through the arthroscope: off, in the corner of the view, or large with the outside in the corner.
void MainWindow::makeScopeActions() {
  QAction* shown = m_actions.addCheckable("scope", {}, {QKeySequence(Qt::Key_O)},
                                          [] { return Actions::Words{tr("Through the ar&throscope"), tr("Show what the arthroscope sees beside the view from outside")}; },
                                          [this](bool on) {
                                            if (m_view) m_view->setScope(on ? SceneView::ScopePlace::Small : SceneView::ScopePlace::Off);
                                          });
  QAction* swap = m_actions.add("scope.swap", {}, {QKeySequence(Qt::Key_X)},
                                [] { return Actions::Words{tr("S&wap arthroscope and outside"), tr("What is small becomes large; dragged tools follow the mouse in the large picture")}; },
                                [this] {
                                  if (m_view) m_view->setScope(m_view->scope() == SceneView::ScopePlace::Large ? SceneView::ScopePlace::Small : SceneView::ScopePlace::Large);
                                });
  for (QAction* action : {shown, swap}) action->setEnabled(m_view != nullptr);
  if (m_view) connect(m_view, &SceneView::scopeChanged, this, [this, shown] { shown->setChecked(m_view->scope() != SceneView::ScopePlace::Off); });
}

}  // namespace glenoid
