// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/JobSystem.h"

#include <algorithm>
#include <new>

#include "editor/core/SameScene.h"
#include "editor/core/Sentences.h"

namespace glenoid {
namespace {

constexpr int kTickMs = 100;   // how often figures are told
constexpr int kGraceMs = 100;  // a cancelled job may end by itself for so long

}  // namespace

JobSystem::JobSystem(Document& document, QObject* parent) : QObject(parent), m_document(document) {
  m_workers.setMaxThreadCount(32);  // jobs are few; one that does not listen must not hold up the next
  m_tick.setInterval(kTickMs);
  connect(&m_tick, &QTimer::timeout, this, &JobSystem::changed);
}

JobSystem::~JobSystem() {
  for (Job& job : m_jobs) job.context->m_cancelled = true;
  m_workers.clear();
  m_workers.waitForDone();
}

JobSystem::StillFits JobSystem::jointIsTheSame() {
  return [](const Scene& then, const Scene& now) { return sameJoint(then.joint, now.joint); };
}

JobSystem::StillFits JobSystem::partsAreTheSame(std::vector<std::string> parts) {
  return [parts = std::move(parts)](const Scene& then, const Scene& now) {
    return std::all_of(parts.begin(), parts.end(), [&](const std::string& id) {
      const int a = findPart(then.joint, id), b = findPart(now.joint, id);
      if (a < 0 || b < 0) return a == b;
      const Cage *cageA = findCage(then.joint, id), *cageB = findCage(now.joint, id);
      if (!cageA != !cageB || (cageA && !(*cageA == *cageB))) return false;
      return samePart(then.joint.parts[a], now.joint.parts[b]);
    });
  };
}

int JobSystem::startJoint(const QString& title, std::function<Result<Joint>(JobContext&)> work, StillFits stillFits) {
  return start<Joint>(title, std::move(work), [this, title](Joint joint) {
    const ChangeSet changes = changesBetween(m_document.joint(), joint);
    if (sameJoint(m_document.joint(), joint)) return;
    m_document.edit(title, changes, [&](Scene& scene) { scene.joint = joint; });
  }, std::move(stillFits));
}

int JobSystem::begin(const QString& title, std::function<Outcome(JobContext&)> work, StillFits stillFits) {
  Job job{++m_last, title, m_document.scene(), stillFits ? std::move(stillFits) : jointIsTheSame(),
          std::make_shared<JobContext>(), {}};
  job.clock.start();
  const int id = job.id;
  m_workers.start([this, id, context = job.context, work = std::move(work)] {
    Outcome outcome;
    try {
      outcome = work(*context);
    } catch (const std::bad_alloc&) {
      outcome.error = Error{Fault::OutOfMemory, {}, {}, "job"};
    } catch (const std::exception& bug) {  // a library's, which its wrapper let through
      outcome.error = Error{Fault::Internal, {}, {}, bug.what()};
    }
    QMetaObject::invokeMethod(this, [this, id, outcome = std::move(outcome)]() mutable { take(id, std::move(outcome)); },
                              Qt::QueuedConnection);
  });
  m_jobs.push_back(std::move(job));
  m_tick.start();
  emit changed();
  return id;
}

void JobSystem::take(int id, Outcome outcome) {
  const auto found = std::find_if(m_jobs.begin(), m_jobs.end(), [&](const Job& job) { return job.id == id; });
  if (found == m_jobs.end()) return;  // let go meanwhile
  const Job job = std::move(*found);
  m_jobs.erase(found);
  if (m_jobs.empty()) m_tick.stop();
  emit changed();
  if (!job.context->goesOn()) {
    emit ended(id, End::Cancelled, {});
  } else if (outcome.error) {
    const bool asked = outcome.error->fault == Fault::Cancelled;
    emit ended(id, asked ? End::Cancelled : End::Failed, asked ? QString() : sentenceOf(*outcome.error));
  } else if (!job.stillFits(job.then, m_document.scene())) {
    emit ended(id, End::Dropped,
               tr("“%1” was dropped: the scene was changed in what it works on. Start it again.").arg(job.title));
  } else {
    outcome.apply();
    emit ended(id, End::Applied, {});
  }
}

void JobSystem::letGo(int id) {
  const auto found = std::find_if(m_jobs.begin(), m_jobs.end(), [&](const Job& job) { return job.id == id; });
  if (found == m_jobs.end()) return;
  m_jobs.erase(found);
  if (m_jobs.empty()) m_tick.stop();
  emit changed();
  emit ended(id, End::Cancelled, {});
}

void JobSystem::cancel(int id) {
  for (Job& job : m_jobs) {
    if (job.id != id || !job.context->goesOn()) continue;
    job.context->m_cancelled = true;
    QTimer::singleShot(kGraceMs, Qt::PreciseTimer, this, [this, id] { letGo(id); });
    emit changed();
    return;
  }
}

void JobSystem::cancelAll() {
  for (const Info& info : jobs()) cancel(info.id);
}

std::vector<JobSystem::Info> JobSystem::jobs() const {
  std::vector<Info> list;
  for (const Job& job : m_jobs) {
    Info info{job.id, job.title, {}, std::clamp(job.context->m_done.load(), 0.0, 1.0), -1, !job.context->goesOn()};
    {
      const std::lock_guard lock(job.context->m_mutex);
      info.phase = job.context->m_phase;
    }
    const double seconds = job.clock.elapsed() * 1e-3;
    if (seconds > 1 && info.done > 0.02) info.remaining = seconds * (1 - info.done) / info.done;
    list.push_back(std::move(info));
  }
  return list;
}

}  // namespace glenoid
