// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <atomic>
#include <functional>
#include <mutex>
#include <thread>

#include "simcore/device/DeviceLink.h"

namespace glenoid {

/// A thread that talks with a device until it is told to end, and what it tells of that.
class IoThread {
 public:
  ~IoThread() { stop(); }
  void start(std::function<void()> body) { m_thread = std::thread(std::move(body)); }
  void stop() {
    m_quit = true;
    if (m_thread.joinable()) m_thread.join();
  }
  bool quit() const { return m_quit.load(std::memory_order_relaxed); }

  /// The thread that talks; never the haptic one.
  void tell(const std::function<void(DeviceStory&)>& change) {
    const std::lock_guard lock(m_mutex);
    change(m_story);
  }
  DeviceStory story() const {
    const std::lock_guard lock(m_mutex);
    return m_story;
  }

 private:
  std::atomic<bool> m_quit{false};
  mutable std::mutex m_mutex;
  DeviceStory m_story;
  std::thread m_thread;
};

}  // namespace glenoid
