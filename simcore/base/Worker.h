// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace glenoid {

/// One thread that does one prepared job again and again, on call. Between start() and wait() the caller must
/// not touch what the job touches. start() and wait() allocate nothing. The job must not throw.
class Worker {
 public:
  explicit Worker(std::function<void()> job);
  ~Worker();
  Worker(const Worker&) = delete;
  Worker& operator=(const Worker&) = delete;
  void start();
  void wait();

 private:
  void loop();
  std::function<void()> m_job;
  std::mutex m_mutex;
  std::condition_variable m_changed;
  enum class Phase { Idle, Asked, Leaving } m_phase = Phase::Idle;
  std::thread m_thread;  // last: starts when everything else stands
};

}  // namespace glenoid
