// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QWidget>

#include "editor/core/JobSystem.h"

class QLabel;
class QProgressBar;
class QToolButton;

namespace glenoid {

/// The jobs under way, in the status bar: what the first one does, how far it is, how long it will take, and a button
/// that stops it. Hidden while nothing is under way.
class JobsBar : public QWidget {
  Q_OBJECT
 public:
  explicit JobsBar(JobSystem& jobs, QWidget* parent = nullptr);

 protected:
  void changeEvent(QEvent* event) override;

 private:
  void refresh();

  JobSystem& m_jobs;
  QLabel* m_text;
  QProgressBar* m_bar;
  QToolButton* m_cancel;
  int m_shown = 0;  ///< job
};

}  // namespace glenoid
