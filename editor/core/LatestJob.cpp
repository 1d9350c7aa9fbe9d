// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/LatestJob.h"

namespace glenoid {

LatestJob::LatestJob(QObject* parent) : QObject(parent) {
  m_pool.setMaxThreadCount(1);
}

LatestJob::~LatestJob() {
  drop();
  m_pool.waitForDone();
}

void LatestJob::drop() {
  if (m_stale) *m_stale = true;
  m_stale.reset();
  m_pool.clear();
}

void LatestJob::ask(Work work) {
  drop();
  m_stale = std::make_shared<std::atomic<bool>>(false);
  m_pool.start([this, stale = m_stale, work = std::move(work)] {
    if (*stale) return;
    Answer answer = work(*stale);
    QMetaObject::invokeMethod(
        this,
        [this, stale, answer = std::move(answer)] {
          if (*stale) return;
          m_stale.reset();
          if (answer) answer();
        },
        Qt::QueuedConnection);
  });
}

}  // namespace glenoid
