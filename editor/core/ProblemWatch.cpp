// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/ProblemWatch.h"

#include "editor/core/ProblemSentences.h"
#include "simcore/check/FixProblem.h"

namespace glenoid {

ProblemWatch::ProblemWatch(Document& document, JobSystem& jobs, QObject* parent)
    : QObject(parent), m_document(document), m_jobs(jobs) {
  m_worker.setMaxThreadCount(1);
  m_rest.setSingleShot(true);
  m_rest.setInterval(250);  // after the last of a burst of edits
  connect(&m_rest, &QTimer::timeout, this, &ProblemWatch::look);
  connect(&document, &Document::changed, this, [this](const ChangeSet& changes) {
    if (m_stop) *m_stop = true;
    ++m_generation;
    if (changes.everything && !m_report.problems.empty()) {
      m_report = {};
      emit changed();
    }
    m_rest.start();
    if (!m_checking) {
      m_checking = true;
      emit checkingChanged();
    }
  });
  if (!document.isEmpty()) look();
}

ProblemWatch::~ProblemWatch() {
  if (m_stop) *m_stop = true;
  m_worker.clear();
  m_worker.waitForDone();
}

void ProblemWatch::look() {
  m_worker.clear();
  m_stop = std::make_shared<std::atomic<bool>>(false);
  if (!m_checking) {
    m_checking = true;
    emit checkingChanged();
  }
  m_worker.start([this, generation = m_generation, scene = m_document.scene(), stop = m_stop, finder = m_finder] {
    Result<CheckReport> report = CheckReport{};
    if (!scene.joint.parts.empty()) report = finder->find(scene.joint, &scene.scenario, [&] { return !*stop; });
    QMetaObject::invokeMethod(
        this, [this, generation, report = std::move(report)]() mutable { take(generation, std::move(report)); },
        Qt::QueuedConnection);
  });
}

void ProblemWatch::take(long generation, Result<CheckReport> report) {
  if (generation != m_generation || !report.ok()) return;  // a newer look is on its way
  m_report = std::move(report).value();
  m_checking = false;
  emit checkingChanged();
  emit changed();
}

void ProblemWatch::fix(const Problem& problem) {
  if (!canFix(problem)) return;
  m_jobs.startJoint(fixTitleOf(problem, m_document.joint()), [problem, joint = m_document.joint()](JobContext& context) {
    return fixProblem(joint, problem, [&](double done) { return context.progress(done); });
  });
}

}  // namespace glenoid
