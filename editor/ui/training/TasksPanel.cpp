// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/training/TasksPanel.h"

#include <QEvent>
#include <QHeaderView>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPushButton>
#include <QTableWidget>
#include <QVBoxLayout>
#include <algorithm>

#include "editor/core/TrainingSentences.h"

namespace glenoid {
namespace {

QLabel* wrappedLabel(const char* name) {
  auto* label = new QLabel;
  label->setObjectName(QLatin1String(name));
  label->setWordWrap(true);
  label->setTextFormat(Qt::PlainText);
  return label;
}

/// A sign beside the word, so that nobody needs the colour.
QString signOf(TaskOutcome outcome) {
  switch (outcome) {
    case TaskOutcome::Waiting: return QStringLiteral("○");
    case TaskOutcome::Open: return QStringLiteral("▶");
    case TaskOutcome::Done: return QStringLiteral("✓");
    case TaskOutcome::Missed: return QStringLiteral("✗");
  }
  return {};
}

}  // namespace

TasksPanel::TasksPanel(Document& document, PlayLink& link, QWidget* parent)
    : QWidget(parent),
      m_document(document),
      m_link(link),
      m_intro(wrappedLabel("trainingText")),
      m_list(new QListWidget),
      m_text(wrappedLabel("taskText")),
      m_hint(new QPushButton),
      m_sentence(wrappedLabel("trainingResult")),
      m_figures(new QTableWidget(0, 2)),
      m_formula(wrappedLabel("metricFormula")),
      m_again(new QPushButton),
      m_trainee(new QLineEdit),
      m_traineeLabel(new QLabel),
      m_runs(new QPushButton),
      m_kept(wrappedLabel("recordSentence")) {
  m_list->setObjectName(QStringLiteral("taskList"));
  m_list->setWordWrap(true);
  m_list->setTextElideMode(Qt::ElideNone);
  m_list->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  m_hint->setObjectName(QStringLiteral("taskHint"));
  m_figures->setObjectName(QStringLiteral("trainingFigures"));
  m_figures->verticalHeader()->hide();
  m_figures->horizontalHeader()->setSectionResizeMode(0, QHeaderView::Stretch);
  m_figures->horizontalHeader()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
  m_figures->setEditTriggers(QAbstractItemView::NoEditTriggers);
  m_figures->setSelectionBehavior(QAbstractItemView::SelectRows);
  m_figures->setSelectionMode(QAbstractItemView::SingleSelection);
  m_figures->setTabKeyNavigation(false);
  m_again->setObjectName(QStringLiteral("trainAgain"));
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 8, 8, 8);
  m_trainee->setObjectName(QStringLiteral("trainee"));
  m_trainee->setMaxLength(200);
  m_traineeLabel->setBuddy(m_trainee);
  m_runs->setObjectName(QStringLiteral("ownRunsButton"));
  auto* who = new QHBoxLayout;
  who->addWidget(m_traineeLabel);
  who->addWidget(m_trainee, 1);
  who->addWidget(m_runs);
  layout->addWidget(m_intro);
  layout->addLayout(who);
  layout->addWidget(m_list, 2);
  layout->addWidget(m_text);
  layout->addWidget(m_hint, 0, Qt::AlignLeft);
  layout->addWidget(m_sentence);
  layout->addWidget(m_figures, 3);
  layout->addWidget(m_formula);
  layout->addWidget(m_kept);
  layout->addWidget(m_again, 0, Qt::AlignLeft);
  connect(&link, &PlayLink::snapshotChanged, this, &TasksPanel::refresh);
  connect(&document, &Document::changed, this, &TasksPanel::rebuild);
  connect(m_list, &QListWidget::currentRowChanged, this, &TasksPanel::refreshText);
  connect(m_hint, &QPushButton::clicked, this, [this] {
    m_hinted = true;
    m_hintTask = shownTask();
    if (m_hintTask >= 0 && m_hintTask < static_cast<int>(m_listed.tasks.size()) && !m_listed.tasks[static_cast<std::size_t>(m_hintTask)].hidden) {
      std::set<std::string> parts;
      for (const TaskPlace& place : m_listed.tasks[static_cast<std::size_t>(m_hintTask)].places)
        if (!place.part.empty()) parts.insert(place.part);
      if (!parts.empty()) emit showWanted(parts);
    }
    refreshText();
  });
  connect(m_figures, &QTableWidget::currentCellChanged, this, [this](int row) {
    const QTableWidgetItem* item = row < 0 ? nullptr : m_figures->item(row, 0);
    m_formula->setText(item ? metricFormula(item->data(Qt::UserRole).toString().toStdString()) : QString());
  });
  connect(m_again, &QPushButton::clicked, this, [this] {
    m_link.reset();
    m_link.play();
  });
  connect(m_runs, &QPushButton::clicked, this, &TasksPanel::runsWanted);
  connect(m_trainee, &QLineEdit::editingFinished, this, [this] {
    m_name = m_trainee->text().trimmed();
    refreshText();
  });
  setRecordSentence({});
  rebuild();
}

QString TasksPanel::trainee() const { return m_name; }

void TasksPanel::setRecordSentence(const QString& sentence) {
  m_kept->setText(sentence);
  m_kept->setVisible(!sentence.isEmpty());
}

const Training& TasksPanel::training() const { return m_document.scenario().training; }

/// The chosen one, else the first that is open.
int TasksPanel::shownTask() const {
  if (m_list->currentRow() >= 0) return m_list->currentRow();
  if (!m_report) return training().tasks.empty() ? -1 : 0;
  const auto open = std::find_if(m_report->tasks.begin(), m_report->tasks.end(), [](const TaskResult& task) { return task.record.outcome == TaskOutcome::Open; });
  return open == m_report->tasks.end() ? -1 : static_cast<int>(open - m_report->tasks.begin());
}

void TasksPanel::rebuild() {
  if (m_listed == training() && m_list->count() == static_cast<int>(training().tasks.size())) return refreshText();
  const bool appeared = m_listed.tasks.empty() && !training().tasks.empty();
  m_listed = training();
  m_report.reset();
  m_hinted = false;
  m_list->clear();
  for (const Task& task : m_listed.tasks) m_list->addItem(QString::fromStdString(task.name.empty() ? task.id : task.name));
  m_figures->setRowCount(0);
  refresh();
  if (appeared) emit tasksAppeared();
}

void TasksPanel::refresh() {
  const auto& report = m_link.snapshot().training;
  const auto isOf = [](const TaskResult& result, const Task& task) { return result.id == task.id; };
  if (report && report != m_report && std::equal(report->tasks.begin(), report->tasks.end(), m_listed.tasks.begin(), m_listed.tasks.end(), isOf)) {
    const bool wasFinished = m_report && m_report->finished;
    m_report = report;
    for (std::size_t i = 0; i < report->tasks.size(); ++i) {
      const TaskRecord& record = report->tasks[i].record;
      QString row = QStringLiteral("%1 %2 – %3").arg(signOf(record.outcome), taskName(report->tasks[i]), outcomeWord(record.outcome));
      if (record.outcome == TaskOutcome::Open && record.progress > 0) row += QStringLiteral(" %1 %").arg(qRound(100 * record.progress));
      if (record.errors > 0) row += QStringLiteral(", ") + tr("%n error(s)", nullptr, record.errors);
      QListWidgetItem* item = m_list->item(static_cast<int>(i));
      if (item->text() != row) item->setText(row);
    }
    if (report->finished != wasFinished) {
      m_figures->setRowCount(0);
      if (report->finished) fillFigures(*report);
    }
  }
  refreshText();
}

void TasksPanel::refreshText() {
  const bool any = !m_listed.tasks.empty(), finished = m_report && m_report->finished;
  m_intro->setText(any ? QString::fromStdString(m_listed.text) : tr("This scene has no tasks."));
  m_intro->setVisible(!any || !m_listed.text.empty());
  const int shown = shownTask();
  const Task* task = any && shown >= 0 && shown < static_cast<int>(m_listed.tasks.size()) ? &m_listed.tasks[static_cast<std::size_t>(shown)] : nullptr;
  if (shown != m_hintTask) m_hinted = false;
  QString text = task ? QString::fromStdString(task->text) : QString();
  if (task && m_hinted) text += (text.isEmpty() ? QString() : QStringLiteral("\n")) + QString::fromStdString(task->hint);
  m_text->setText(text);
  m_text->setVisible(!text.isEmpty());
  m_list->setVisible(any);
  m_hint->setVisible(task && (!task->hint.empty() || !task->hidden));
  m_hint->setEnabled(!m_hinted);
  m_hint->setText(tr("&Hint"));
  m_sentence->setVisible(any && m_report);
  if (m_report) m_sentence->setText(trainingSentence(*m_report));
  m_figures->setVisible(finished);
  m_formula->setVisible(finished);
  m_again->setVisible(finished);
  m_again->setText(tr("&Again"));
  for (QWidget* widget : std::initializer_list<QWidget*>{m_traineeLabel, m_trainee, m_runs}) widget->setVisible(any);
  m_traineeLabel->setText(tr("&Name"));
  m_trainee->setPlaceholderText(tr("to keep the run for you"));
  m_runs->setText(tr("My &runs…"));
  m_runs->setEnabled(!trainee().isEmpty());
  m_figures->setHorizontalHeaderLabels({tr("What was measured"), tr("Value")});
}

void TasksPanel::fillFigures(const TrainingReport& report) {
  const auto add = [&](const QString& words, const QString& figure, const std::string& metric) {
    const int row = m_figures->rowCount();
    m_figures->insertRow(row);
    auto* first = new QTableWidgetItem(words);
    first->setData(Qt::UserRole, QString::fromStdString(metric));
    m_figures->setItem(row, 0, first);
    auto* second = new QTableWidgetItem(figure);
    second->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    m_figures->setItem(row, 1, second);
  };
  const Scenario& scenario = m_document.scenario();
  for (const FormResult& row : report.form)
    add(metricWords(row.row.metric, scenario), tr("%1 of %2 points").arg(qRound(row.points)).arg(qRound(row.row.points)), row.row.metric);
  for (const ReferenceResult& row : report.references)
    if (row.z) add(metricWords(row.figure.metric, scenario), tr("%1 deviations from others").arg(*row.z, 0, 'f', 1), row.figure.metric);
  for (const BenchmarkResult& row : report.benchmarks)
    add(QString::fromStdString(row.benchmark.name.empty() ? row.benchmark.metric : row.benchmark.name),
        !row.value ? QStringLiteral("–") : row.kept ? tr("kept (at most %1)").arg(metricFigure(row.benchmark.metric, row.benchmark.limit)) : tr("not kept (at most %1)").arg(metricFigure(row.benchmark.metric, row.benchmark.limit)),
        row.benchmark.metric);
  for (const Metric& metric : report.metrics) add(metricWords(metric.name, scenario), metricFigure(metric.name, metric.value), metric.name);
}

void TasksPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) {
    auto report = std::move(m_report);
    m_report.reset();
    refresh();
    if (!m_report) m_report = std::move(report);
    refreshText();
  }
  QWidget::changeEvent(event);
}

}  // namespace glenoid
