// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QWidget>

#include "editor/core/PlayLink.h"

class QLabel;
class QPushButton;
class QToolButton;

namespace glenoid {

/// The line above the view that says what must be said about the run: the gravest notice, and how many more there are in the
/// list of problems. It stays until it is closed or the run begins anew, and comes back when something else is to be said.
class NoticeStrip : public QWidget {
  Q_OBJECT
 public:
  NoticeStrip(const Document& document, const PlayLink& link, QWidget* parent = nullptr);

 signals:
  void allWanted();  ///< the whole list is to be shown

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void refresh();
  void close();

  const Document& m_document;
  const PlayLink& m_link;
  std::vector<Notice> m_closed;  ///< what was on show when it was closed
  QLabel* m_words;
  QPushButton* m_all;
  QToolButton* m_close;
};

}  // namespace glenoid
