// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QObject>
#include <vector>

#include "editor/core/tools/Authoring.h"
#include "editor/ui/Actions.h"

class QDockWidget;
class QMainWindow;
class QMenu;
class QToolBar;

namespace glenoid {

class JobSystem;
class SceneView;

/// The author's part of the window: the tools with their buttons and keys, and their panels beside the
/// properties. Made after the window's own docks; the view may be null.
class AuthorDocks : public QObject {
  Q_OBJECT
 public:
  AuthorDocks(QMainWindow& window, Actions& actions, Document& document, JobSystem& jobs,
              DisplayState& display, Selection& selection, SceneView* view);
  ~AuthorDocks() override;

  Authoring& authoring() { return m_authoring; }
  QMenu* menu() const { return m_menu; }
  QToolBar* toolBar() const { return m_toolBar; }
  const std::vector<QDockWidget*>& docks() const { return m_docks; }
  void retranslate();

 private:
  void makeActions(Actions& actions);
  void addDock(const char* name, QWidget* content, Qt::DockWidgetArea area = Qt::RightDockWidgetArea);

  QMainWindow& m_window;
  SceneView* m_view;
  Authoring m_authoring;
  QMenu* m_menu = nullptr;
  QToolBar* m_toolBar = nullptr;
  std::vector<QDockWidget*> m_docks;
};

}  // namespace glenoid
