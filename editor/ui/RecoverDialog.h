// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QDialog>
#include <optional>

#include "editor/core/AutosaveStore.h"

class QLabel;
class QPushButton;
class QTreeWidget;

namespace glenoid {

/// What programs that ended without saving left: when, of what, from where. Recovering answers one generation; declining
/// keeps it, to be found again under File > Recover.
class RecoverDialog : public QDialog {
  Q_OBJECT
 public:
  explicit RecoverDialog(std::vector<AbandonedSession> sessions, QWidget* parent = nullptr);

  /// The generation and the session that were chosen when the dialog was accepted.
  const Generation* chosen() const;
  const AbandonedSession* chosenSession() const;

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void retranslate();
  void refresh();
  void removeChosen();

  std::vector<AbandonedSession> m_sessions;
  QLabel* m_text;
  QTreeWidget* m_list;
  QPushButton *m_recover, *m_later, *m_remove;
};

}  // namespace glenoid
