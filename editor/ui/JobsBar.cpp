// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/JobsBar.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QToolButton>
#include <cmath>

namespace glenoid {

JobsBar::JobsBar(JobSystem& jobs, QWidget* parent) : QWidget(parent), m_jobs(jobs) {
  setObjectName(QStringLiteral("jobsBar"));
  m_text = new QLabel;
  m_text->setObjectName(QStringLiteral("jobText"));
  m_bar = new QProgressBar;
  m_bar->setObjectName(QStringLiteral("jobProgress"));
  m_bar->setMaximumWidth(140);
  m_bar->setRange(0, 1000);
  m_bar->setTextVisible(false);
  m_cancel = new QToolButton;
  m_cancel->setObjectName(QStringLiteral("cancelJob"));
  m_cancel->setText(QStringLiteral("✕"));
  m_cancel->setAutoRaise(true);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(8, 0, 8, 0);
  row->addWidget(m_text);
  row->addWidget(m_bar);
  row->addWidget(m_cancel);
  connect(m_cancel, &QToolButton::clicked, this, [this] { m_jobs.cancel(m_shown); });
  connect(&jobs, &JobSystem::changed, this, &JobsBar::refresh);
  refresh();
}

void JobsBar::refresh() {
  const auto jobs = m_jobs.jobs();
  setVisible(!jobs.empty());
  m_cancel->setToolTip(tr("Stop this work; nothing will be changed"));
  m_cancel->setAccessibleName(tr("Stop this work"));
  m_bar->setAccessibleName(tr("How far the work is"));
  if (jobs.empty()) return;
  const JobSystem::Info& job = jobs.front();
  m_shown = job.id;
  QString text = job.phase.isEmpty() ? tr("%1…").arg(job.title) : tr("%1: %2").arg(job.title, job.phase);
  if (job.cancelling) {
    text = tr("Stopping…");
  } else if (job.remaining >= 90) {
    text = tr("%1 (about %n minute(s) left)", nullptr, static_cast<int>(std::lround(job.remaining / 60))).arg(text);
  } else if (job.remaining >= 0) {
    text = tr("%1 (about %n second(s) left)", nullptr, static_cast<int>(std::ceil(job.remaining))).arg(text);
  }
  if (jobs.size() > 1) text = tr("%1 and %n more", nullptr, static_cast<int>(jobs.size()) - 1).arg(text);
  m_text->setText(text);
  m_bar->setRange(0, job.done > 0 ? 1000 : 0);  // no figure yet: it only moves
  m_bar->setValue(static_cast<int>(std::lround(1000 * job.done)));
  m_cancel->setEnabled(!job.cancelling);
}

void JobsBar::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) refresh();
  QWidget::changeEvent(event);
}

}  // namespace glenoid
