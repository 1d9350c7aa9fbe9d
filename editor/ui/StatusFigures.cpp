// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/StatusFigures.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>

#include "editor/ui/Numbers.h"

namespace glenoid {

StatusFigures::StatusFigures(PlayLink& link, QWidget* parent) : QWidget(parent), m_link(link) {
  static constexpr const char* kNames[kCount] = {"time", "speed", "stepsPerSecond", "msPerStep",
                                                 "contacts", "islands", "fps"};
  auto* layout = new QHBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  for (int i = 0; i < kCount; ++i) {
    m_labels[i] = new QLabel;
    m_labels[i]->setObjectName(QStringLiteral("figure.") + QLatin1String(kNames[i]));
    m_labels[i]->setProperty("role", QStringLiteral("figure"));
    layout->addWidget(m_labels[i]);
  }
  reserveWidths();
  m_timer.setInterval(200);
  connect(&m_timer, &QTimer::timeout, this, &StatusFigures::refresh);
  m_timer.start();
  refresh();
}

// Room for the longest likely text, so that nothing is cut off and nothing jumps about while figures change.
void StatusFigures::reserveWidths() {
  const std::array<QString, kCount> widest = {
      tr("%1 s").arg(number(8888.88, 2)),
      tr("%1 % of real time").arg(number(888.0, 0)),
      tr("%1 steps/s").arg(number(8888.0, 0)),
      tr("%1 ms/step").arg(number(888.88, 2)),
      tr("%n contact(s)", nullptr, 888),
      tr("%n island(s)", nullptr, 88),
      tr("%1 fps").arg(number(888.0, 0)),
  };
  for (int i = 0; i < kCount; ++i) {
    m_labels[i]->ensurePolished();
    m_labels[i]->setMinimumWidth(m_labels[i]->fontMetrics().horizontalAdvance(widest[i]) + 20);  // 20: see the theme
  }
}

void StatusFigures::refresh() {
  const Snapshot& s = m_link.snapshot();
  const bool runs = s.playing;
  const std::array<QString, kCount> words = {
      tr("%1 s").arg(number(s.time, 2)),
      runs ? tr("%1 % of real time").arg(number(100 * s.rates.realTimeFactor, 0)) : tr("paused"),
      tr("%1 steps/s").arg(number(runs ? s.rates.stepsPerSecond : 0, 0)),
      tr("%1 ms/step").arg(number(s.rates.msPerStep, 2)),
      tr("%n contact(s)", nullptr, s.report.contacts),
      tr("%n island(s)", nullptr, s.report.contactIslands),
      tr("%1 fps").arg(number(m_fps ? m_fps() : 0, 0)),
  };
  const std::array<QString, kCount> tips = {
      tr("Simulated time"),
      tr("How fast the simulation runs against the clock; below 100 % it is too slow for this computer"),
      tr("Simulation steps in one second"),
      tr("Time that one step takes, mean of the last half second"),
      tr("Contacts of the last step, of which %1 press").arg(s.report.pressing),
      tr("Groups of parts that touch each other"),
      tr("Pictures drawn in the last second; none are drawn while nothing changes"),
  };
  for (int i = 0; i < kCount; ++i) {
    if (m_labels[i]->text() != words[i]) m_labels[i]->setText(words[i]);
    m_labels[i]->setToolTip(tips[i]);
  }
}

void StatusFigures::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    reserveWidths();
    refresh();
  }
  QWidget::changeEvent(event);
}

}  // namespace glenoid
