// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/HistoryPanel.h"

#include <QEvent>

#include "editor/ui/Theme.h"

namespace glenoid {

HistoryPanel::HistoryPanel(QUndoStack& stack, QWidget* parent) : QUndoView(&stack, parent) {
  setObjectName(QStringLiteral("history"));
  setUniformItemSizes(true);
  retranslate();
}

void HistoryPanel::retranslate() {
  setAccessibleName(tr("History of changes"));
  setEmptyLabel(tr("As it was opened"));
  setCleanIcon(themedTreeIcon(QStringLiteral("save")));  // the step that is on disk
}

void HistoryPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange) retranslate();
  QUndoView::changeEvent(event);
}

}  // namespace glenoid
