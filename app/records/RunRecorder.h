// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <atomic>
#include <chrono>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "simcore/base/Error.h"
#include "simcore/live/RunReport.h"

namespace glenoid {

/// Keeps a run in the records while it goes on: a thread of its own writes how far it is, three times a second by the clock, so that
/// a server that is slow or restarts holds up nothing and a program that is killed loses less than a second. Made, fed and
/// finished in one thread; gone, it waits for no server.
class RunRecorder {
 public:
  static constexpr double kEvery = 0.3;  ///< s of the clock between two writes

  struct Who {
    std::string place, person, scenario, build, jointHash;
  };
  /// Begins at once in its thread; begun() says when, or why not.
  explicit RunRecorder(const Who& who);
  /// The same and waits. Fails as RecordStore does.
  static Result<std::unique_ptr<RunRecorder>> begin(const Who& who);
  ~RunRecorder();

  /// Nothing as long as it is not known.
  std::optional<Result<Done>> begun() const;
  /// Whether kEvery has gone by since the last tell(); cheap.
  bool isDue() const;
  /// `seconds`: simulated so far. Only the newest is written.
  void tell(double seconds, TrainingReport training);
  /// Writes the end in its thread; finished() says when, or why not.
  void close(RunReport report);
  std::optional<Result<Done>> finished() const;
  /// The same and waits.
  Result<Done> finish(const RunReport& report);

 private:
  void work(const Who& who);

  mutable std::mutex m_mutex;
  std::condition_variable m_wake, m_answered;
  std::optional<Result<Done>> m_begun, m_finished;
  std::optional<std::pair<double, TrainingReport>> m_newest;
  std::optional<RunReport> m_report;
  std::atomic<bool> m_quit{false};
  std::chrono::steady_clock::time_point m_told{};
  std::thread m_worker;
};

}  // namespace glenoid
