// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <condition_variable>
#include <mutex>
#include <optional>
#include <string>
#include <thread>

#include "simcore/base/Error.h"
#include "simcore/live/RunReport.h"

namespace glenoid {

/// Keeps a run in the records while it goes on: a thread of its own writes how far it is, three times a second by the clock, so that
/// a server that is slow or restarts holds up nothing and a program that is killed loses less than a second. Made, fed and
/// finished in one thread.
class RunRecorder {
 public:
  static constexpr double kEvery = 0.3;  ///< s of the clock between two writes

  struct Who {
    std::string place, person, scenario, build, jointHash;
  };
  /// Fails as RecordStore does.
  static Result<std::unique_ptr<RunRecorder>> begin(const Who& who);
  ~RunRecorder();

  /// Whether kEvery has gone by since the last tell(); cheap.
  bool isDue() const;
  /// `seconds`: simulated so far. Only the newest is written.
  void tell(double seconds, TrainingReport training);
  /// Writes the end and waits for it.
  Result<Done> finish(const RunReport& report);

 private:
  RunRecorder() = default;
  void work(const Who& who);

  mutable std::mutex m_mutex;
  std::condition_variable m_wake, m_answered;
  std::optional<Result<Done>> m_begun, m_finished;
  std::optional<std::pair<double, TrainingReport>> m_newest;
  const RunReport* m_report = nullptr;
  bool m_quit = false;
  std::chrono::steady_clock::time_point m_told{};
  std::thread m_worker;
};

}  // namespace glenoid
