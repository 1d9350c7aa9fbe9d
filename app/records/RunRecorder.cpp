// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/records/RunRecorder.h"

#include "app/records/RecordStore.h"

namespace glenoid {

RunRecorder::RunRecorder(const Who& who) : m_worker([this, who] { work(who); }) {}

Result<std::unique_ptr<RunRecorder>> RunRecorder::begin(const Who& who) {
  auto recorder = std::make_unique<RunRecorder>(who);
  std::unique_lock lock(recorder->m_mutex);
  recorder->m_answered.wait(lock, [&] { return recorder->m_begun.has_value(); });
  if (!*recorder->m_begun) return recorder->m_begun->error();
  lock.unlock();
  return recorder;
}

RunRecorder::~RunRecorder() {
  {
    const std::lock_guard lock(m_mutex);
    m_quit = true;
  }
  m_wake.notify_one();
  m_worker.join();
}

std::optional<Result<Done>> RunRecorder::begun() const {
  const std::lock_guard lock(m_mutex);
  return m_begun;
}

std::optional<Result<Done>> RunRecorder::finished() const {
  const std::lock_guard lock(m_mutex);
  return m_finished;
}

bool RunRecorder::isDue() const { return std::chrono::duration<double>(std::chrono::steady_clock::now() - m_told).count() >= kEvery; }

void RunRecorder::tell(double seconds, TrainingReport training) {
  m_told = std::chrono::steady_clock::now();
  {
    const std::lock_guard lock(m_mutex);
    m_newest.emplace(seconds, std::move(training));
  }
  m_wake.notify_one();
}

void RunRecorder::close(RunReport report) {
  {
    const std::lock_guard lock(m_mutex);
    m_report = std::move(report);
  }
  m_wake.notify_one();
}

Result<Done> RunRecorder::finish(const RunReport& report) {
  close(report);
  std::unique_lock lock(m_mutex);
  m_answered.wait(lock, [&] { return m_finished.has_value(); });
  return *m_finished;
}

/// A connection of Qt's belongs to the thread that made it.
void RunRecorder::work(const Who& who) {
  auto store = RecordStore::open(who.place, 30, [this] { return !m_quit; });
  long long run = 0;
  std::optional<Error> wrong;
  if (store) {
    const auto begun = (*store)->begin(who.person, who.scenario, who.build, who.jointHash);
    if (begun) run = *begun;
    else wrong = begun.error();
  } else {
    wrong = store.error();
  }
  std::unique_lock lock(m_mutex);
  m_begun = wrong ? Result<Done>(*wrong) : Result<Done>(Done{});
  m_answered.notify_one();
  if (wrong) return;
  while (true) {
    m_wake.wait(lock, [&] { return m_quit || m_newest || m_report; });
    if (m_report) {
      const RunReport report = std::move(*m_report);
      m_report.reset();
      lock.unlock();
      auto finished = (*store)->finish(run, report);
      lock.lock();
      m_newest.reset();
      m_finished = std::move(finished);
      m_answered.notify_one();
      continue;
    }
    if (m_quit) return;
    const auto [seconds, training] = std::move(*m_newest);
    m_newest.reset();
    lock.unlock();
    (void)(*store)->progress(run, seconds, training);  // what could not be written now is in the next, or in the end
    lock.lock();
  }
}

}  // namespace glenoid
