// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QElapsedTimer>
#include <QObject>
#include <QString>
#include <QThreadPool>
#include <QTimer>
#include <atomic>
#include <functional>
#include <memory>
#include <mutex>
#include <vector>

#include "editor/core/Document.h"

namespace glenoid {

/// What a job says of itself while it works, and what it may ask. Shared between its worker and the window.
class JobContext {
 public:
  /// False once it was cancelled: the work should end soon; what it answers is thrown away.
  bool goesOn() const { return !m_cancelled.load(std::memory_order_relaxed); }
  /// Set once it was cancelled: for a library that looks for itself.
  const std::atomic<bool>& cancelled() const { return m_cancelled; }
  /// 0…1 of the whole job. Answers goesOn().
  bool progress(double done) {
    m_done.store(done, std::memory_order_relaxed);
    return goesOn();
  }
  /// A few words for people about what it does now, in their language.
  void phase(const QString& words) {
    const std::lock_guard lock(m_mutex);
    m_phase = words;
  }

 private:
  friend class JobSystem;
  std::atomic<bool> m_cancelled{false};
  std::atomic<double> m_done{0};
  std::mutex m_mutex;
  QString m_phase;
};

/// Work in the background whose result becomes one undo step, or nothing at all. The work gets values and never sees the
/// document; its result is applied on the GUI thread, if the document is still what it was made for. Cancelling takes the
/// job off the list within 0.2 s even where the work does not listen; its thread then ends on its own and its answer is
/// dropped. GUI thread only, except for what JobContext says. The destructor cancels and waits.
class JobSystem : public QObject {
  Q_OBJECT
 public:
  /// Whether the document still holds what the job was given: the scene at its start, and the scene now.
  using StillFits = std::function<bool(const Scene& then, const Scene& now)>;

  struct Info {
    int id = 0;
    QString title, phase;
    double done = 0;        ///< 0…1
    double remaining = -1;  ///< s; −1: not known yet
    bool cancelling = false;
  };
  /// How a job ended.
  enum class End { Applied, Cancelled, Failed, Dropped };

  explicit JobSystem(Document& document, QObject* parent = nullptr);
  ~JobSystem() override;

  /// Starts `work` on a worker. With its value `apply` is called, which makes at most one edit of the document. By default
  /// any change of the joint makes the result unfit. Answers the job's number.
  template <class T>
  int start(const QString& title, std::function<Result<T>(JobContext&)> work, std::function<void(T)> apply,
            StillFits stillFits = {}) {
    return begin(title, [work = std::move(work), apply = std::move(apply)](JobContext& context) -> Outcome {
      auto result = std::make_shared<Result<T>>(work(context));
      if (!result->ok()) return {result->error(), {}};
      return {{}, [result, apply] { apply(std::move(*result).value()); }};
    }, std::move(stillFits));
  }
  /// The same for a joint made from another: one undo step called `title`. Nothing happens when it comes back the same.
  int startJoint(const QString& title, std::function<Result<Joint>(JobContext&)> work, StillFits stillFits = {});

  void cancel(int id);
  void cancelAll();
  std::vector<Info> jobs() const;  ///< in the order in which they began
  bool busy() const { return !m_jobs.empty(); }

  static StillFits jointIsTheSame();
  /// Of these parts alone, with their cages.
  static StillFits partsAreTheSame(std::vector<std::string> parts);

 signals:
  void changed();  ///< the list or a figure in it, at most ten times a second
  /// `sentence`: for people, empty when all went well or they asked to stop.
  void ended(int id, glenoid::JobSystem::End end, const QString& sentence);

 private:
  struct Outcome {
    std::optional<Error> error;
    std::function<void()> apply;
  };
  struct Job {
    int id;
    QString title;
    Scene then;
    StillFits stillFits;
    std::shared_ptr<JobContext> context;
    QElapsedTimer clock;
  };
  int begin(const QString& title, std::function<Outcome(JobContext&)> work, StillFits stillFits);
  void take(int id, Outcome outcome);
  void letGo(int id);

  Document& m_document;
  std::vector<Job> m_jobs;
  int m_last = 0;
  QTimer m_tick;
  QThreadPool m_workers;
};

}  // namespace glenoid
