// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QUndoView>

namespace glenoid {

/// Every step that can be undone or redone, in order; a click goes there.
class HistoryPanel : public QUndoView {
  Q_OBJECT
 public:
  explicit HistoryPanel(QUndoStack& stack, QWidget* parent = nullptr);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void retranslate();
};

}  // namespace glenoid
