// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/base/Worker.h"

namespace glenoid {

Worker::Worker(std::function<void()> job) : m_job(std::move(job)), m_thread([this] { loop(); }) {}

Worker::~Worker() {
  {
    std::unique_lock lock(m_mutex);
    m_changed.wait(lock, [this] { return m_phase == Phase::Idle; });
    m_phase = Phase::Leaving;
  }
  m_changed.notify_all();
  m_thread.join();
}

void Worker::start() {
  {
    const std::lock_guard lock(m_mutex);
    m_phase = Phase::Asked;
  }
  m_changed.notify_all();
}

void Worker::wait() {
  std::unique_lock lock(m_mutex);
  m_changed.wait(lock, [this] { return m_phase == Phase::Idle; });
}

void Worker::loop() {
  std::unique_lock lock(m_mutex);
  while (true) {
    m_changed.wait(lock, [this] { return m_phase != Phase::Idle; });
    if (m_phase == Phase::Leaving) return;
    lock.unlock();
    m_job();
    lock.lock();
    m_phase = Phase::Idle;
    m_changed.notify_all();
  }
}

}  // namespace glenoid
