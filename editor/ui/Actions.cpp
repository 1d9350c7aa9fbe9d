// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/Actions.h"

#include <QWidget>

#include "editor/ui/Theme.h"

namespace glenoid {

Actions::Actions(QWidget* window) : QObject(window), m_window(window) {}

QAction* Actions::make(const QString& id, const QString& icon, const QList<QKeySequence>& shortcuts, Source words) {
  auto* action = new QAction(m_window);
  action->setObjectName(QStringLiteral("action.") + id);
  if (!icon.isEmpty()) action->setIcon(themedIcon(icon));
  action->setShortcuts(shortcuts);
  m_window->addAction(action);  // the shortcut works where the action is in no visible menu
  m_entries[id] = {action, std::move(words)};
  return action;
}

QAction* Actions::add(const QString& id, const QString& icon, const QList<QKeySequence>& shortcuts, Source words,
                      std::function<void()> run) {
  QAction* action = make(id, icon, shortcuts, std::move(words));
  connect(action, &QAction::triggered, this, [run = std::move(run)] { run(); });
  return action;
}

QAction* Actions::addCheckable(const QString& id, const QString& icon, const QList<QKeySequence>& shortcuts,
                               Source words, std::function<void(bool)> run) {
  QAction* action = make(id, icon, shortcuts, std::move(words));
  action->setCheckable(true);
  connect(action, &QAction::triggered, this, [run = std::move(run)](bool on) { run(on); });
  return action;
}

QAction* Actions::operator[](const QString& id) const {
  const auto found = m_entries.find(id);
  return found == m_entries.end() ? nullptr : found->second.action;
}

void Actions::retranslate() {
  for (const auto& [id, entry] : m_entries) {
    const Words words = entry.words();
    entry.action->setText(words.text);
    const QString keys = entry.action->shortcut().toString(QKeySequence::NativeText);
    entry.action->setToolTip(keys.isEmpty() ? words.tip : QStringLiteral("%1 (%2)").arg(words.tip, keys));
    entry.action->setStatusTip(words.tip);
  }
}

}  // namespace glenoid
