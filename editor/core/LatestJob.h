// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QObject>
#include <QThreadPool>
#include <atomic>
#include <functional>
#include <memory>

namespace glenoid {

/// Work for a preview that follows a slider: runs on a worker, and only the latest wish counts. Wishes that
/// have not begun are dropped, one under way is told that it is stale and its answer is thrown away. For work
/// that a person waits for, with progress and a button to cancel, there are jobs. GUI thread only; the
/// destructor waits.
class LatestJob : public QObject {
 public:
  using Answer = std::function<void()>;  ///< runs on the GUI thread
  using Work = std::function<Answer(const std::atomic<bool>& stale)>;

  explicit LatestJob(QObject* parent = nullptr);
  ~LatestJob() override;
  void ask(Work work);
  void drop();
  bool busy() const { return m_stale != nullptr; }

 private:
  QThreadPool m_pool;
  std::shared_ptr<std::atomic<bool>> m_stale;  ///< of the latest wish, null: answered
};

}  // namespace glenoid
