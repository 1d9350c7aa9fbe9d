// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QAction>
#include <QKeySequence>
#include <functional>
#include <map>

namespace glenoid {

/// The one registry of what a window can do: menus, toolbars and shortcuts take their actions from here. Texts
/// are asked for again by retranslate().
class Actions : public QObject {
  Q_OBJECT
 public:
  /// What an action says, made new in each language.
  struct Words {
    QString text, tip;
  };
  using Source = std::function<Words()>;

  explicit Actions(QWidget* window);

  QAction* add(const QString& id, const QString& icon, const QList<QKeySequence>& shortcuts, Source words,
               std::function<void()> run);
  QAction* addCheckable(const QString& id, const QString& icon, const QList<QKeySequence>& shortcuts, Source words,
                        std::function<void(bool)> run);
  QAction* operator[](const QString& id) const;  ///< null when unknown
  void retranslate();

 private:
  struct Entry {
    QAction* action;
    Source words;
  };
  QAction* make(const QString& id, const QString& icon, const QList<QKeySequence>& shortcuts, Source words);

  QWidget* m_window;
  std::map<QString, Entry> m_entries;
};

}  // namespace glenoid
