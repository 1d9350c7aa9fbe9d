// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QElapsedTimer>
#include <QObject>
#include <QProcess>
#include <QTimer>

#include "editor/lab/StudyFolder.h"

namespace glenoid {

/// A study in a process of its own, so that drawing does not spoil its times, watched by the files that it writes. It ends with this object,
/// and with the window's program whatever becomes of that. GUI thread only.
class StudyProcess : public QObject {
  Q_OBJECT
 public:
  enum class End { Done, Cancelled, Failed };

  explicit StudyProcess(QObject* parent = nullptr);
  ~StudyProcess() override;

  /// `program study KIND …` that writes to `folder`, which exists. Not while one runs.
  void start(const QString& program, const QStringList& arguments, const QString& folder);
  void cancel();
  bool isRunning() const { return m_process.state() != QProcess::NotRunning; }
  /// Shows the study of a folder that is there already. Fails as StudyFolder::open does.
  Result<Done> open(const QString& folder);

  const StudyFolder& study() const { return m_study; }
  double secondsRemaining() const;  ///< −1: cannot be told yet, or nothing runs

 signals:
  void changed();  ///< something new was read, or a second went by
  /// `sentence`: for people, of what failed or could not be done; empty: all went well, or they asked to stop.
  void ended(glenoid::StudyProcess::End end, const QString& sentence);

 private:
  void look();
  void finish(int status, QProcess::ExitStatus how);

  QProcess m_process;
  StudyFolder m_study;
  QTimer m_look;
  QElapsedTimer m_clock;
  double m_remaining = -1;
  bool m_cancelled = false;
};

}  // namespace glenoid
