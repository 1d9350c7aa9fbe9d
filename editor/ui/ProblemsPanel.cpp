// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/ProblemsPanel.h"

#include <QEvent>
#include <QLabel>
#include <QListWidget>
#include <QPushButton>
#include <QVBoxLayout>

#include "editor/core/NoticeSentences.h"
#include "editor/core/ProblemSentences.h"
#include "editor/ui/Theme.h"
#include "simcore/check/FixProblem.h"

namespace glenoid {
namespace {

QString iconOf(Severity severity) {
  switch (severity) {
    case Severity::Error: return QStringLiteral("problem-error");
    case Severity::Warning: return QStringLiteral("problem-warning");
    case Severity::Note: break;
  }
  return QStringLiteral("problem-note");
}

std::set<std::string> partsOf(const Problem& problem) {
  std::set<std::string> parts(problem.parts.begin(), problem.parts.end());
  if (!problem.part.empty()) parts.insert(problem.part);
  if (problem.kind != ProblemKind::NoMaterial && !problem.other.empty()) parts.insert(problem.other);
  return parts;
}

}  // namespace

ProblemsPanel::ProblemsPanel(Document& document, ProblemWatch& watch, const PlayLink& link, QWidget* parent)
    : QWidget(parent), m_document(document), m_watch(watch), m_link(link) {
  m_summary = new QLabel;
  m_summary->setObjectName(QStringLiteral("problemSummary"));
  m_summary->setWordWrap(true);
  m_list = new QListWidget;
  m_list->setObjectName(QStringLiteral("problemList"));
  m_list->setWordWrap(true);
  m_list->setTextElideMode(Qt::ElideNone);
  m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_list->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  m_advice = new QLabel;  // wraps, where the text of a button would widen the whole dock
  m_advice->setObjectName(QStringLiteral("fixAdvice"));
  m_advice->setWordWrap(true);
  m_fix = new QPushButton;
  m_fix->setObjectName(QStringLiteral("fixProblem"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 8, 8, 8);
  layout->addWidget(m_summary);
  layout->addWidget(m_list, 1);
  layout->addWidget(m_advice);
  layout->addWidget(m_fix);
  connect(&watch, &ProblemWatch::changed, this, &ProblemsPanel::rebuild);
  connect(&watch, &ProblemWatch::checkingChanged, this, &ProblemsPanel::refresh);
  connect(&link, &PlayLink::noticesChanged, this, &ProblemsPanel::rebuild);
  connect(m_list, &QListWidget::currentRowChanged, this, &ProblemsPanel::refresh);
  connect(m_list, &QListWidget::itemActivated, this, [this] {
    if (const Problem* problem = current()) emit showWanted(partsOf(*problem));
    if (const Notice* notice = currentNotice()) emit showWanted(objectsOf(*notice));
  });
  connect(m_fix, &QPushButton::clicked, this, [this] {
    if (const Problem* problem = current()) m_watch.fix(*problem);
  });
  rebuild();
}

const Problem* ProblemsPanel::current() const {
  const int row = m_list->currentRow();
  return row < 0 || row >= static_cast<int>(m_watch.problems().size()) ? nullptr : &m_watch.problems()[row];
}

const Notice* ProblemsPanel::currentNotice() const {
  const int row = m_list->currentRow() - static_cast<int>(m_watch.problems().size());
  return row < 0 || row >= static_cast<int>(m_notices.size()) ? nullptr : &m_notices[row];
}

std::set<std::string> ProblemsPanel::objectsOf(const Notice& notice) const {
  std::set<std::string> parts;
  for (const std::string& id : {notice.subject, notice.other})
    if (findPart(m_document.joint(), id) >= 0 || findTool(m_document.scenario(), id) >= 0) parts.insert(id);
  return parts;
}

void ProblemsPanel::rebuild() {
  const int row = m_list->currentRow();
  {
    const QSignalBlocker quiet(m_list);
    m_list->clear();
    for (const Problem& problem : m_watch.problems()) {
      const QString sentence = sentenceOf(problem, m_document.joint());
      auto* item = new QListWidgetItem(themedTreeIcon(iconOf(problem.severity)), sentence, m_list);
      item->setToolTip(severityName(problem.severity));
      item->setData(Qt::AccessibleTextRole, QStringLiteral("%1: %2").arg(severityName(problem.severity), sentence));
    }
    m_notices = m_link.notices();
    std::erase_if(m_notices, [this](const Notice& notice) {
      return notice.kind == NoticeKind::UnusedSetting &&
             std::any_of(m_watch.problems().begin(), m_watch.problems().end(), [](const Problem& p) { return p.kind == ProblemKind::SettingUnused; });
    });
    for (const Notice& notice : m_notices) {
      const Severity severity = isGrave(notice.kind) ? Severity::Error : Severity::Warning;
      const QString sentence = sentenceOf(notice, namesIn(m_document.joint(), m_document.scenario()));
      auto* item = new QListWidgetItem(themedTreeIcon(iconOf(severity)), sentence, m_list);
      item->setToolTip(tr("Of this run"));
      item->setData(Qt::AccessibleTextRole, QStringLiteral("%1: %2").arg(severityName(severity), sentence));
    }
    m_list->setCurrentRow(std::min(row, m_list->count() - 1));
  }
  refresh();
}

void ProblemsPanel::refresh() {
  m_list->setAccessibleName(tr("Problems of the joint"));
  const CheckReport& report = m_watch.report();
  QString summary;
  if (m_watch.isChecking()) {
    summary = tr("Looking for problems…");
  } else if (m_document.isEmpty()) {
    summary = tr("No scene is open.");
  } else if (report.problems.empty()) {
    summary = tr("No problems were found.");
  } else {
    summary = QStringList{tr("%n error(s)", nullptr, report.count(Severity::Error)),
                          tr("%n warning(s)", nullptr, report.count(Severity::Warning)),
                          tr("%n note(s)", nullptr, report.count(Severity::Note))}
                  .join(tr(", "));
  }
  if (!m_notices.empty()) summary += QLatin1Char('\n') + tr("%n notice(s) about the run", nullptr, static_cast<int>(m_notices.size()));
  m_summary->setText(summary);
  const Problem* problem = current();
  const QString fix = problem ? fixTitleOf(*problem, m_document.joint()) : QString();
  // What was found before the last change may be gone already.
  m_fix->setEnabled(!fix.isEmpty() && !m_watch.isChecking());
  m_fix->setText(tr("Fix"));
  m_fix->setToolTip(fix);
  m_advice->setText(!problem ? QString() : fix.isEmpty() ? tr("This one needs your judgement.") : tr("Fix: %1").arg(fix));
}

void ProblemsPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange || event->type() == QEvent::PaletteChange) rebuild();
  QWidget::changeEvent(event);
}

}  // namespace glenoid
