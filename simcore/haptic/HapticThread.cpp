// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/haptic/HapticThread.h"

#include <sched.h>
#include <sys/prctl.h>
#include <time.h>

#include <cmath>
#include <system_error>

namespace glenoid {

namespace {

constexpr int kPriority = 40;    // below what a kernel gives its own
constexpr long kTellEvery = 100;  // ticks

timespec timespecOf(std::int64_t ns) { return {static_cast<time_t>(ns / 1'000'000'000), static_cast<long>(ns % 1'000'000'000)}; }

}  // namespace

std::int64_t steadyNow() {
  timespec now{};
  clock_gettime(CLOCK_MONOTONIC, &now);
  return 1'000'000'000LL * now.tv_sec + now.tv_nsec;
}

HapticThread::HapticThread(const HapticSettings& settings, HapticDevice& device, TripleBuffer<LocalProblem>& problems, std::span<HapticSample> log)
    : m_loop(settings), m_device(device), m_problems(problems) {
  m_loop.setLog(log);
  pthread_attr_t attributes;
  pthread_attr_init(&attributes);
  const sched_param priority{kPriority};
  int failed = pthread_attr_setinheritsched(&attributes, PTHREAD_EXPLICIT_SCHED);
  if (!failed) failed = pthread_attr_setschedpolicy(&attributes, SCHED_FIFO);
  if (!failed) failed = pthread_attr_setschedparam(&attributes, &priority);
  if (!failed) failed = pthread_create(&m_thread, &attributes, &HapticThread::enter, this);
  pthread_attr_destroy(&attributes);
  if (failed) {
    failed = pthread_create(&m_thread, nullptr, &HapticThread::enter, this);
    if (failed) throw std::system_error(failed, std::generic_category(), "haptic thread");
  }
  m_running = true;
}

HapticThread::~HapticThread() { stop(); }

void HapticThread::stop() {
  if (!m_running) return;
  m_quit.store(true, std::memory_order_relaxed);
  pthread_join(m_thread, nullptr);
  m_running = false;
}

const HapticStatus& HapticThread::status() {
  m_status.take();
  return m_status.front();
}

const HandWord& HapticThread::hand() {
  m_hand.take();
  return m_hand.front();
}

void* HapticThread::enter(void* self) {
  static_cast<HapticThread*>(self)->run();
  return nullptr;
}

void HapticThread::tell(std::int64_t now) {
  HapticStatus& status = m_status.back();
  status.counts = m_loop.counts();
  int policy = SCHED_OTHER;
  sched_param parameters{};
  pthread_getschedparam(pthread_self(), &policy, &parameters);  // as it is, not as it was asked for
  status.scheduling = policy == SCHED_FIFO ? HapticScheduling::Fifo : HapticScheduling::Ordinary;
  status.seconds = 1e-9 * static_cast<double>(now - m_begun);
  status.rateHz = status.seconds > 0 ? static_cast<double>(status.counts.ticks) / status.seconds : 0;
  status.missed = m_missed;
  status.latenessP50Us = m_times.percentileUs(0.5);
  status.latenessP99Us = m_times.percentileUs(0.99);
  status.latenessP999Us = m_times.percentileUs(0.999);
  status.latenessMaxUs = m_times.worstUs();
  m_status.publish();
}

void HapticThread::run() {
  prctl(PR_SET_TIMERSLACK, 1UL);  // ns; means nothing to a FIFO thread
  const auto period = static_cast<std::int64_t>(std::llround(1e9 / m_loop.settings().rate));
  std::int64_t due = steadyNow() + period;
  m_begun = due - period;
  ToolInput input;
  while (!m_quit.load(std::memory_order_relaxed)) {
    const timespec at = timespecOf(due);
    while (clock_nanosleep(CLOCK_MONOTONIC, TIMER_ABSTIME, &at, nullptr) != 0) {}
    const std::int64_t now = steadyNow(), late = now - due;
    m_times.add(late);
    const std::int64_t passed = late / period;
    m_missed += static_cast<long>(passed);
    m_problems.take();
    const bool present = m_device.read(now, input);
    const auto answer = m_loop.tick(now, 1e-9 * static_cast<double>((1 + passed) * period), present, input, m_problems.front());
    m_device.write(answer.force, answer.torque);
    if (const std::optional<Pose>& hand = m_loop.hand()) {
      m_hand.back() = {true, *hand};
      m_hand.publish();
    }
    due += (1 + passed) * period;
    if (m_loop.counts().ticks % kTellEvery == 0) tell(steadyNow());
  }
  m_device.write(Vec3::Zero(), Vec3::Zero());
  tell(due - period);  // a rate is that of whole periods
}

}  // namespace glenoid
