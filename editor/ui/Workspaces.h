// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QMap>
#include <QObject>
#include <QStringList>

#include "editor/ui/Actions.h"

class QActionGroup;
class QMainWindow;
class QMenu;

namespace glenoid {

/// What a window shows for one kind of work, by object names of docks and tool bars.
struct Workspace {
  QString id;
  Actions::Source words;
  QKeySequence shortcut;
  QStringList shown;  ///< docks and bars, the first dock in front
  int sideWidth = 0;  ///< px, of the docks at the right when it is shown for the first time; 0: as they are
};

/// One workspace at a time. What a window holds beside all that any workspace names stays as it is. Each remembers how its docks were left.
class Workspaces : public QObject {
  Q_OBJECT
 public:
  Workspaces(QMainWindow& window, Actions& actions);

  void add(Workspace workspace);  ///< the first is the one that is shown
  void show(const QString& id);   ///< nothing where it is unknown
  const QString& current() const { return m_current; }
  QMenu* menu() const { return m_menu; }

 signals:
  void changed(const QString& id);

 private:
  void arrange(const Workspace& workspace);

  QMainWindow& m_window;
  Actions& m_actions;
  std::vector<Workspace> m_workspaces;
  QMap<QString, QByteArray> m_left;  ///< by id: the window's state when it was left
  QString m_current;
  QMenu* m_menu;
  QActionGroup* m_group;
};

}  // namespace glenoid
