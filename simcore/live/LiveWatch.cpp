// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/live/LiveWatch.h"

#include <algorithm>
#include <chrono>
#include <cmath>

#include "simcore/live/PenetrationProbe.h"
#include "simcore/live/Run.h"
#include "simcore/live/RunWatch.h"

namespace glenoid {
namespace {

/// Whether a list says anything that the one told last does not: another notice, or a depth that has grown.
bool worthTelling(const std::vector<Notice>& last, const std::vector<Notice>& now) {
  return std::any_of(now.begin(), now.end(), [&](const Notice& notice) {
    const auto there = std::find_if(last.begin(), last.end(), [&](const Notice& n) {
      return n.kind == notice.kind && n.subject == notice.subject && n.other == notice.other;
    });
    return there == last.end() || notice.figure >= LiveWatch::kDeeper * there->figure;
  });
}

}  // namespace

LiveWatch::LiveWatch(std::shared_ptr<const Model> model, std::shared_ptr<const Recording> input, std::function<void()> told)
    : m_model(std::move(model)),
      m_input(std::move(input)),
      m_told(std::move(told)),
      m_marks(*m_model, m_input.get()),
      m_restWatch(*m_model, m_input.get()),
      m_judged(m_marks.reports().size(), 0),
      m_onPathSince(HUGE_VAL),
      m_before(noticesBefore(*m_model, m_input.get(), m_input ? inputSeconds(*m_input) : 0)),
      m_notices(std::make_shared<const std::vector<Notice>>(m_before)),
      m_worker([this] { work(); }) {}

LiveWatch::~LiveWatch() {
  {
    const std::lock_guard lock(m_mutex);
    m_quit = true;
  }
  m_wake.notify_one();
  m_worker.join();
}

std::shared_ptr<const std::vector<Notice>> LiveWatch::notices() const {
  const std::lock_guard lock(m_mutex);
  return m_notices;
}

void LiveWatch::look(const StepReport& step, const State& state, bool onPath) {
  judgeMarks(step, state, onPath);
  m_restWatch.add(step, state.time - m_model->scenario.dt, state.v);
  m_rest = {true, m_restWatch.loadsRise(), m_restWatch.speed(), m_restWatch.isSlow()};
  {
    const std::lock_guard lock(m_mutex);
    m_newest.state.q = state.q;
    m_newest.state.time = state.time;
    m_newest.state.step = state.step;
    m_newest.dents = step.dents;
    m_fresh = true;
  }
  m_wake.notify_one();
}

void LiveWatch::judgeMarks(const StepReport& step, const State& state, bool onPath) {
  const double dt = m_model->scenario.dt, begin = state.time - dt;
  if (!onPath) m_onPathSince = HUGE_VAL;
  else m_onPathSince = std::min(m_onPathSince, begin);
  m_marks.add(step, begin);
  for (std::size_t i = 0; i < m_judged.size(); ++i) {
    const MarkReport& mark = m_marks.reports()[i];
    if (m_judged[i] || state.time < mark.end - dt / 2) continue;
    m_judged[i] = 1;
    if (mark.begin < m_onPathSince - dt / 2 || !m_model->effectOn("contact") || !isMissed(mark)) continue;
    const std::lock_guard lock(m_mutex);
    m_missed.push_back(missedMark(mark, dt));
    tell();
  }
}

void LiveWatch::add(const Notice& notice) {
  const std::lock_guard lock(m_mutex);
  m_missed.push_back(notice);
  tell();
}

void LiveWatch::tell() {
  std::vector<Notice> all = m_before;
  for (const auto* list : {&m_missed, &m_found}) all.insert(all.end(), list->begin(), list->end());
  m_notices = std::make_shared<const std::vector<Notice>>(std::move(all));
}

void LiveWatch::work() {
  using Clock = std::chrono::steady_clock;
  RunWatch watch(*m_model, m_model->scenario.profile != Profile::Paper);
  PenetrationProbe probe(*m_model, SurfaceKind::Collision);
  probe.setLimit(std::nullopt);
  Seen seen;
  std::unique_lock lock(m_mutex);
  while (true) {
    m_wake.wait(lock, [this] { return m_quit || m_fresh; });
    if (m_quit) return;
    std::swap(seen, m_newest);
    m_fresh = false;
    lock.unlock();
    const Clock::time_point begin = Clock::now();
    watch.look(seen.state);
    probe.look(seen.state.q, seen.dents, seen.state.time, seen.state.step);
    std::vector<Notice> found = watch.notices();
    for (const Notice& deep : probe.tooDeep()) found.push_back(deep);
    const Clock::duration took = Clock::now() - begin;
    lock.lock();
    if (worthTelling(m_found, found)) {
      m_found = std::move(found);
      tell();
      lock.unlock();
      if (m_told) m_told();
      lock.lock();
    }
    m_wake.wait_for(lock, kRest * took, [this] { return m_quit; });
  }
}

std::unique_ptr<StepWatch> makeLiveWatch(std::shared_ptr<const Model> model, std::shared_ptr<const Recording> input, std::function<void()> told) {
  return std::make_unique<LiveWatch>(std::move(model), std::move(input), std::move(told));
}

}  // namespace glenoid
