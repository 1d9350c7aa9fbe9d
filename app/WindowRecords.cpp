// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/WindowRecords.h"

#include <QDateTime>
#include <QDialog>
#include <QDialogButtonBox>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QTableWidget>
#include <QVBoxLayout>

#include "app/records/RecordStore.h"
#include "editor/core/Sentences.h"
#include "editor/ui/training/TasksPanel.h"
#include "simcore/live/BuildId.h"

namespace glenoid {

WindowRecords::WindowRecords(Document& document, PlayLink& link, TasksPanel& panel, std::string place, QObject* parent)
    : QObject(parent), m_document(document), m_link(link), m_panel(panel), m_place(std::move(place)) {
  connect(&link, &PlayLink::snapshotChanged, this, &WindowRecords::look);
  // A model or a recording that changes under way begins another training; what was begun stays as not ended.
  const auto begunAnew = [this] {
    m_recorder.reset();
    m_kept = false;
  };
  connect(&link, &PlayLink::compiled, this, begunAnew);
  connect(&link, &PlayLink::followChanged, this, begunAnew);
  connect(&panel, &TasksPanel::runsWanted, this, &WindowRecords::showRuns);
}

void WindowRecords::look() {
  const Snapshot& snapshot = m_link.snapshot();
  if (m_link.hasGuest() || !snapshot.training || !snapshot.model || snapshot.model->scenario.training.tasks.empty()) {
    m_recorder.reset();
    return;
  }
  if (snapshot.time < m_seconds || (m_recorder && snapshot.time == 0)) {  // begun again
    m_recorder.reset();
    m_kept = false;
    m_panel.setRecordSentence({});
  }
  m_seconds = snapshot.time;
  if (m_kept || m_panel.trainee().isEmpty() || snapshot.time == 0) return;
  if (!m_recorder) begin();
  if (const auto begun = m_recorder->begun(); begun && !*begun) return settle(sentenceOf(begun->error()));
  if (const auto finished = m_recorder->finished()) return settle(*finished ? tr("Kept for %1.").arg(m_name) : sentenceOf(finished->error()));
  if (m_closing) return;
  if (snapshot.training->finished) return close(*snapshot.training, snapshot.time);
  if (m_recorder->isDue()) m_recorder->tell(snapshot.time, *snapshot.training);
}

void WindowRecords::begin() {
  const std::string scenario = m_document.path().isEmpty() ? m_document.scenario().id : m_document.path().toStdString();
  m_name = m_panel.trainee();
  m_recorder = std::make_unique<RunRecorder>(RunRecorder::Who{m_place, m_name.toStdString(), scenario, buildId(), m_link.snapshot().model->jointHash});
  m_closing = false;
}

/// What became of it, once for a run.
void WindowRecords::settle(const QString& sentence) {
  m_recorder.reset();
  m_kept = true;
  m_panel.setRecordSentence(sentence);
}

void WindowRecords::close(const TrainingReport& training, double seconds) {
  RunReport report;
  report.scenario = m_document.scenario().id;
  report.profile = profileName(m_document.scenario().profile);
  report.build = buildId();
  report.jointHash = m_link.snapshot().model->jointHash;
  report.dt = m_document.scenario().dt;
  report.steps = m_link.snapshot().step;
  report.seconds = seconds;
  report.realtime = true;
  report.training = training;
  m_recorder->close(std::move(report));
  m_closing = true;
  m_panel.setRecordSentence(tr("Being kept …"));
}

/// Their own, by the name they gave.
void WindowRecords::showRuns() {
  const auto store = RecordStore::open(m_place, 0);
  const auto runs = store ? (*store)->list(m_panel.trainee().toStdString()) : Result<std::vector<RecordedRun>>(store.error());
  QDialog dialog(m_panel.window());
  dialog.setObjectName(QStringLiteral("ownRuns"));
  dialog.setWindowTitle(tr("Runs of %1").arg(m_panel.trainee()));
  auto* layout = new QVBoxLayout(&dialog);
  if (!runs) {
    auto* words = new QLabel(runs.error().fault == Fault::UnknownId ? tr("Nothing is kept for %1 yet.").arg(m_panel.trainee()) : sentenceOf(runs.error()));
    words->setWordWrap(true);
    layout->addWidget(words);
  } else {
    auto* table = new QTableWidget(static_cast<int>(runs->size()), 4);
    table->setObjectName(QStringLiteral("ownRunsTable"));
    table->setHorizontalHeaderLabels({tr("When"), tr("Scene"), tr("Tasks"), tr("Score")});
    table->verticalHeader()->hide();
    table->setEditTriggers(QAbstractItemView::NoEditTriggers);
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    table->horizontalHeader()->setStretchLastSection(true);
    for (int row = 0; row < table->rowCount(); ++row) {
      const RecordedRun& run = (*runs)[static_cast<std::size_t>(row)];
      const QDateTime begun = QDateTime::fromString(QString::fromStdString(run.begun), Qt::ISODateWithMs).toLocalTime();
      const QString score = !run.ended ? tr("not ended") : run.score ? QLocale().toString(*run.score, 'f', 0) + (run.passed ? tr(", passed") : QString()) : QStringLiteral("–");
      const QString cells[] = {QLocale().toString(begun, QLocale::ShortFormat), QString::fromStdString(run.scenario), QStringLiteral("%1 / %2").arg(run.done).arg(run.tasks), score};
      for (int column = 0; column < 4; ++column) table->setItem(row, column, new QTableWidgetItem(cells[column]));
    }
    layout->addWidget(table);
    dialog.resize(640, 360);
  }
  auto* buttons = new QDialogButtonBox(QDialogButtonBox::Close);
  connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
  layout->addWidget(buttons);
  dialog.exec();
}

}  // namespace glenoid
