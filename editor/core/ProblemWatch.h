// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QObject>
#include <QThreadPool>
#include <QTimer>
#include <atomic>
#include <memory>

#include "editor/core/Document.h"
#include "editor/core/JobSystem.h"
#include "simcore/check/FindProblems.h"

namespace glenoid {

/// Keeps the problem list of the document: looks again on a worker soon after each change, and never blocks the window. A
/// look that a newer change overtakes is stopped. GUI thread only; the destructor waits for the worker.
class ProblemWatch : public QObject {
  Q_OBJECT
 public:
  /// Both must outlive this.
  ProblemWatch(Document& document, JobSystem& jobs, QObject* parent = nullptr);
  ~ProblemWatch() override;

  const std::vector<Problem>& problems() const { return m_report.problems; }
  const CheckReport& report() const { return m_report; }
  /// A change has not been looked at yet.
  bool isChecking() const { return m_checking; }
  /// Does what canFix() promises, as one undo step, in the background.
  void fix(const Problem& problem);

 signals:
  void changed();          ///< other problems
  void checkingChanged();

 private:
  void look();
  void take(long generation, Result<CheckReport> report);

  Document& m_document;
  JobSystem& m_jobs;
  CheckReport m_report;
  std::shared_ptr<ProblemFinder> m_finder = std::make_shared<ProblemFinder>();  ///< the worker's alone
  std::shared_ptr<std::atomic<bool>> m_stop;
  long m_generation = 0;
  bool m_checking = false;
  QTimer m_rest;
  QThreadPool m_worker;
};

}  // namespace glenoid
