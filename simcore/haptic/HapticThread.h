// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <pthread.h>

#include <atomic>
#include <memory>

#include "simcore/base/TripleBuffer.h"
#include "simcore/haptic/HapticLoop.h"
#include "simcore/haptic/TickTimes.h"

namespace glenoid {

/// How the operating system runs a haptic thread.
enum class HapticScheduling { Fifo, Ordinary };

/// What a haptic thread tells the others, ten times a second.
struct HapticStatus {
  HapticCounts counts;
  HapticScheduling scheduling = HapticScheduling::Ordinary;
  double seconds = 0;             ///< since its first tick
  double rateHz = 0;              ///< ticks done over that
  long missed = 0;                ///< ticks whose time had passed before they could begin; they are not caught up
  double latenessP50Us = 0, latenessP99Us = 0, latenessP999Us = 0, latenessMaxUs = 0;
};

/// Where a haptic thread last believed its hand to be.
struct HandWord {
  bool known = false;      ///< it has ever been
  Pose hand;               ///< W
};

/// ns of the clock that all stamps here are of (steady).
std::int64_t steadyNow();

/// A HapticLoop in a thread of its own, on an absolute clock: tick n is due at start + n/rate whatever the ticks before it took. One
/// that is late begins at once; those whose time has passed by then are counted as missed and left out.
/// Asks for FIFO scheduling by explicit attributes (without those a thread silently runs as an ordinary one); where
/// the system refuses, it runs as an ordinary thread with the finest timer slack, and says so. It does not lock memory: an
/// ordinary user's limit is small, and with future pages locked the next large allocation of the program would fail.
/// Threads: problems are written by one thread through the buffer; status() is read by one thread; stop() and the
/// destructor by the owner.
class HapticThread {
 public:
  /// `device` and `problems` outlive the thread. `log`: see HapticLoop::setLog.
  HapticThread(const HapticSettings& settings, HapticDevice& device, TripleBuffer<LocalProblem>& problems, std::span<HapticSample> log = {});
  ~HapticThread();
  HapticThread(const HapticThread&) = delete;
  HapticThread& operator=(const HapticThread&) = delete;

  /// Shows no force any more, ends and joins; status() is then whole.
  void stop();
  const HapticStatus& status();
  /// The newest; one thread only, which may be another one than status()'s.
  const HandWord& hand();
  /// Samples in the log; after stop().
  std::size_t logged() const { return m_loop.logged(); }

 private:
  static void* enter(void* self);
  void run();
  void tell(std::int64_t now);

  HapticLoop m_loop;
  HapticDevice& m_device;
  TripleBuffer<LocalProblem>& m_problems;
  TripleBuffer<HapticStatus> m_status;
  TripleBuffer<HandWord> m_hand;
  TickTimes m_times;
  std::int64_t m_begun = 0;
  long m_missed = 0;
  std::atomic<bool> m_quit{false};
  bool m_running = false;
  pthread_t m_thread{};
};

}  // namespace glenoid
