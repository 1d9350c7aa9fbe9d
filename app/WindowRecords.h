// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QObject>
#include <memory>
#include <string>

#include "app/records/RunRecorder.h"
#include "editor/core/PlayLink.h"

namespace glenoid {

class TasksPanel;

/// Keeps the trainings of the window in the records: from the first step after somebody has said who they are, as `run
/// --trainee` does, to the last task. A run that is begun again, or whose scene changes, stays as not ended. Says in the panel
/// whether that went well. GUI thread.
class WindowRecords : public QObject {
  Q_OBJECT
 public:
  /// `place`: as RecordStore::open. All must outlive it.
  WindowRecords(Document& document, PlayLink& link, TasksPanel& panel, std::string place, QObject* parent = nullptr);

 private:
  void look();
  void begin();
  void close(const TrainingReport& training, double seconds);
  void settle(const QString& sentence);
  void showRuns();

  Document& m_document;
  PlayLink& m_link;
  TasksPanel& m_panel;
  const std::string m_place;
  std::unique_ptr<RunRecorder> m_recorder;
  QString m_name;            ///< for whom
  double m_seconds = 0;      ///< simulated, when it was last looked at
  bool m_closing = false;    ///< its end is being written
  bool m_kept = false;       ///< this run has its end in the records, or cannot be kept
};

}  // namespace glenoid
