// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/Workspaces.h"

#include <QActionGroup>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QPointer>
#include <QTimer>
#include <QToolBar>
#include <algorithm>

namespace glenoid {

Workspaces::Workspaces(QMainWindow& window, Actions& actions) : QObject(&window), m_window(window), m_actions(actions), m_menu(new QMenu(&window)), m_group(new QActionGroup(this)) {}

void Workspaces::add(Workspace workspace) {
  QAction* action = m_actions.addCheckable(QStringLiteral("workspace.") + workspace.id, {}, {workspace.shortcut}, workspace.words, [this, id = workspace.id](bool on) {
    if (on) show(id);
  });
  m_group->addAction(action);
  m_menu->addAction(action);
  if (m_workspaces.empty()) {
    m_current = workspace.id;
    action->setChecked(true);
  }
  m_workspaces.push_back(std::move(workspace));
}

void Workspaces::show(const QString& id) {
  const auto found = std::find_if(m_workspaces.begin(), m_workspaces.end(), [&](const Workspace& one) { return one.id == id; });
  if (found == m_workspaces.end()) return;
  m_actions[QStringLiteral("workspace.") + id]->setChecked(true);
  if (id == m_current) return;
  m_left[m_current] = m_window.saveState();
  m_current = id;
  if (m_left.contains(id)) m_window.restoreState(m_left[id]);
  else arrange(*found);
  emit changed(id);
}

void Workspaces::arrange(const Workspace& workspace) {
  QStringList others;
  for (const Workspace& one : m_workspaces)
    for (const QString& name : one.shown)
      if (!workspace.shown.contains(name)) others << name;
  const auto widget = [this](const QString& name) { return m_window.findChild<QWidget*>(name, Qt::FindDirectChildrenOnly); };
  for (const QString& name : others)
    if (QWidget* other = widget(name)) other->hide();
  QDockWidget* front = nullptr;
  QList<QDockWidget*> side;
  for (const QString& name : workspace.shown)
    if (QWidget* own = widget(name)) {
      own->show();
      auto* dock = qobject_cast<QDockWidget*>(own);
      if (!front) front = dock;
      if (dock && m_window.dockWidgetArea(dock) == Qt::RightDockWidgetArea) side << dock;
    }
  if (front) front->raise();
  if (workspace.sideWidth <= 0 || side.isEmpty()) return;
  // Docks that were just hidden still hold their places in this turn of the event loop.
  QTimer::singleShot(0, this, [this, dock = QPointer<QDockWidget>(side.first()), width = workspace.sideWidth, id = workspace.id] {
    if (dock && m_current == id) m_window.resizeDocks({dock}, {width}, Qt::Horizontal);
  });
}

}  // namespace glenoid
