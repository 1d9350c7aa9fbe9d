// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/lab/StabilityPanel.h"

#include <QCheckBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLineEdit>
#include <QLocale>
#include <QTableWidget>
#include <QVBoxLayout>
#include <cmath>

#include "editor/core/Sentences.h"
#include "editor/ui/PanelParts.h"
#include "editor/ui/Theme.h"
#include "editor/ui/lab/PictureLabel.h"
#include "editor/ui/lab/StudyBar.h"

namespace glenoid {
namespace {

enum Column { kTrial, kSubject, kStep, kVerdict, kEnergy, kDepth, kRecovery, kInsideOut, kPicture, kColumns };

QString figure(double value, char format, int digits) { return std::isfinite(value) ? QLocale().toString(value, format, digits) : QStringLiteral("–"); }

/// Sorts by what it stands for, not by its letters.
class FigureItem : public QTableWidgetItem {
 public:
  FigureItem(const QString& text, double value) : QTableWidgetItem(text), m_value(std::isfinite(value) ? value : -1) { setTextAlignment(Qt::AlignRight | Qt::AlignVCenter); }
  bool operator<(const QTableWidgetItem& other) const override {
    const auto* figure = dynamic_cast<const FigureItem*>(&other);
    return figure ? m_value < figure->m_value : QTableWidgetItem::operator<(other);
  }

 private:
  double m_value;
};

}  // namespace

StabilityPanel::StabilityPanel(Document& document, PlayLink& link, JobSystem& jobs, const LabServices& services, QWidget* parent)
    : QWidget(parent), m_document(document), m_jobs(jobs), m_services(services), m_replay(link) {
  m_bar = new StudyBar(QStringLiteral("stability"), document, services);
  m_bar->setMoreArguments([this] { return m_cases.isEmpty() ? QStringList() : QStringList{QStringLiteral("--cases"), m_cases.join(u',')}; });
  m_summary = panel::words("lab.stability.summary", "title");
  m_filter = new QLineEdit;
  m_filter->setObjectName(QStringLiteral("lab.stability.filter"));
  m_filter->setClearButtonEnabled(true);
  m_failures = new QCheckBox;
  m_failures->setObjectName(QStringLiteral("lab.stability.failures"));
  m_table = new QTableWidget(0, kColumns);
  m_table->setObjectName(QStringLiteral("lab.stability.table"));
  m_table->setSelectionBehavior(QAbstractItemView::SelectRows);
  m_table->setSelectionMode(QAbstractItemView::SingleSelection);
  m_table->setEditTriggers(QAbstractItemView::NoEditTriggers);
  m_table->setAlternatingRowColors(true);
  m_table->verticalHeader()->hide();
  m_table->setTabKeyNavigation(false);
  m_table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
  m_words = panel::words("lab.stability.verdict");
  m_words->setTextInteractionFlags(Qt::TextSelectableByMouse);
  m_shown = panel::words("lab.stability.shown", "hint");
  m_picture = new PictureLabel;
  m_picture->setObjectName(QStringLiteral("lab.stability.picture"));
  m_picture->setMinimumHeight(150);
  m_play = panel::button("lab.stability.replay");
  m_back = panel::button("lab.stability.back");
  auto* sieve = new QHBoxLayout;
  sieve->addWidget(m_filter, 1);
  sieve->addWidget(m_failures);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(m_play);
  buttons->addWidget(m_back);
  buttons->addStretch(1);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(8, 8, 8, 8);
  layout->addWidget(m_bar);
  layout->addWidget(m_summary);
  layout->addLayout(sieve);
  layout->addWidget(m_table, 3);
  layout->addWidget(m_words);
  layout->addWidget(m_picture, 2);
  layout->addLayout(buttons);
  layout->addWidget(m_shown);
  connect(m_bar, &StudyBar::newsCame, this, &StabilityPanel::refresh);
  connect(m_bar, &StudyBar::begun, this, [this] {  // another study, though its trials may be called the same
    m_table->setRowCount(0);
    refresh();
  });
  connect(m_filter, &QLineEdit::textChanged, this, &StabilityPanel::filter);
  connect(m_failures, &QCheckBox::toggled, this, &StabilityPanel::filter);
  connect(m_table, &QTableWidget::currentCellChanged, this, &StabilityPanel::showCurrent);
  const auto play = [this] {
    if (const int entry = currentEntry(); entry >= 0) replayEntry(static_cast<std::size_t>(entry));
  };
  connect(m_table, &QTableWidget::itemActivated, this, play);
  connect(m_play, &QPushButton::clicked, this, play);
  connect(m_back, &QPushButton::clicked, this, [this] { m_replay.end(); });
  connect(&m_replay, &TrialReplay::changed, this, &StabilityPanel::showCurrent);
  retranslate();
}

int StabilityPanel::currentEntry() const {
  const auto* item = m_table->item(m_table->currentRow(), kTrial);
  const int entry = item ? item->data(Qt::UserRole).toInt() : -1;
  return entry < static_cast<int>(m_entries.size()) ? entry : -1;
}

void StabilityPanel::refresh() {
  std::vector<StabilityEntry> entries = stabilityEntries(m_bar->study());
  const auto told = [](const std::vector<StabilityEntry>& list) {
    std::string words;
    for (const StabilityEntry& entry : list) words += entry.id + entry.profile + (entry.picture.empty() ? "-" : "+");
    return words;
  };
  const bool same = told(entries) == told(m_entries) && m_table->rowCount() == static_cast<int>(entries.size());
  const int kept = currentEntry();
  const std::string current = kept >= 0 ? m_entries[static_cast<std::size_t>(kept)].id + m_entries[static_cast<std::size_t>(kept)].profile : std::string();
  m_entries = std::move(entries);
  m_summary->setText(m_entries.empty() ? QString() : verdictSummary(m_entries));
  m_summary->setVisible(!m_entries.empty());
  if (same) return;
  m_table->setSortingEnabled(false);
  m_table->setRowCount(static_cast<int>(m_entries.size()));
  for (std::size_t k = 0; k < m_entries.size(); ++k) {
    const StabilityEntry& entry = m_entries[k];
    const int row = static_cast<int>(k);
    const auto put = [&](Column column, QTableWidgetItem* item) {
      if (!entry.counts) item->setForeground(currentTheme().color(QStringLiteral("muted")));
      m_table->setItem(row, column, item);
    };
    auto* trial = new QTableWidgetItem(trialWords(entry.what) + (entry.counts ? QString() : tr(" (as published)")));
    trial->setData(Qt::UserRole, row);
    trial->setToolTip(QString::fromStdString(entry.id));
    put(kTrial, trial);
    put(kSubject, new QTableWidgetItem(QString::fromStdString(entry.subject)));
    put(kStep, new FigureItem(figure(entry.stepMs, 'g', 3), entry.stepMs));
    auto* verdict = new QTableWidgetItem(verdictWords(entry));
    put(kVerdict, verdict);
    if (!entry.held) verdict->setForeground(currentTheme().color(entry.counts ? QStringLiteral("error") : QStringLiteral("warning")));
    else if (entry.counts) verdict->setForeground(currentTheme().color(QStringLiteral("good")));
    put(kEnergy, new FigureItem(figure(100 * entry.energyExcess, 'f', 2), entry.energyExcess));
    put(kDepth, new FigureItem(figure(entry.depthMm, 'f', 3), entry.depthMm));
    put(kRecovery, new FigureItem(figure(entry.recoveryS, 'f', 2), entry.recoveryS));
    put(kInsideOut, new FigureItem(QStringLiteral("%1 / %2").arg(entry.insideOutMost).arg(entry.insideOutEnd), static_cast<double>(entry.insideOutMost)));
    auto* picture = new QTableWidgetItem;
    if (!entry.picture.empty()) picture->setIcon(themedTreeIcon(QStringLiteral("picture")));
    picture->setData(Qt::AccessibleTextRole, entry.picture.empty() ? QString() : tr("There is a picture"));
    put(kPicture, picture);
    if (!current.empty() && entry.id + entry.profile == current) m_table->setCurrentCell(row, kTrial);
  }
  m_table->setSortingEnabled(true);
  filter();
  showCurrent();
}

void StabilityPanel::filter() {
  const QString words = m_filter->text();
  for (int row = 0; row < m_table->rowCount(); ++row) {
    const auto* item = m_table->item(row, kTrial);
    if (!item) continue;
    const StabilityEntry& entry = m_entries[static_cast<std::size_t>(item->data(Qt::UserRole).toInt())];
    bool found = words.isEmpty() || QString::fromStdString(entry.id).contains(words, Qt::CaseInsensitive);
    for (const Column column : {kTrial, kSubject, kVerdict}) found = found || m_table->item(row, column)->text().contains(words, Qt::CaseInsensitive);
    m_table->setRowHidden(row, !found || (m_failures->isChecked() && entry.held));
  }
}

void StabilityPanel::showCurrent() {
  const int index = currentEntry();
  const StabilityEntry* entry = index >= 0 ? &m_entries[static_cast<std::size_t>(index)] : nullptr;
  m_words->setText(entry ? QStringLiteral("<b>%1</b><br>%2").arg(QString::fromStdString(entry->id).toHtmlEscaped(), verdictSentence(*entry).toHtmlEscaped()) : QString());
  m_words->setVisible(entry);
  m_picture->setPicture(entry && !entry->picture.empty() ? QImage(QString::fromStdString(entry->picture)) : QImage());
  m_picture->setVisible(!m_picture->isEmpty());
  m_picture->setAccessibleName(entry ? tr("How %1 ended").arg(QString::fromStdString(entry->id)) : QString());
  m_play->setEnabled(entry && !entry->recording.empty() && m_services.trial);
  m_back->setVisible(m_replay.isShown());
  QString shown;
  if (m_replay.isShown()) {
    const QString id = QString::fromStdString(m_replay.trial());
    if (!m_replay.hasEnded()) shown = tr("The view shows %1 again, step for step.").arg(id);
    else if (const auto same = m_replay.sameAsStudied()) shown = *same ? tr("%1 has ended as in the study, bit for bit.").arg(id) : tr("%1 has ended otherwise than in the study: another build, or another processor.").arg(id);
    else shown = tr("%1 has ended.").arg(id);
  }
  m_shown->setText(shown);
  m_shown->setVisible(!shown.isEmpty());
}

void StabilityPanel::replayEntry(std::size_t entry) {
  const std::string& recording = m_entries[entry].recording;
  if (recording.empty()) return m_bar->say(tr("This trial held, so no recording of it was kept."));
  if (!m_services.trial) return;
  m_bar->say({});
  const auto always = [](const Scene&, const Scene&) { return true; };
  m_jobs.start<TrialToReplay>(
      tr("Prepare the trial"), [trial = m_services.trial, recording](JobContext&) { return trial(recording); },
      [this](TrialToReplay trial) {
        m_replay.start(std::move(trial));
        showCurrent();
      },
      always);
}

void StabilityPanel::retranslate() {
  m_filter->setPlaceholderText(tr("Filter by trial, part or verdict"));
  m_filter->setAccessibleName(tr("Filter"));
  m_failures->setText(tr("Only &failures"));
  m_table->setHorizontalHeaderLabels({tr("Trial"), tr("On"), tr("Δt, ms"), tr("Verdict"), tr("Energy, %"), tr("Depth, mm"), tr("Recovery, s"), tr("Inside out"), tr("Picture")});
  const QString tips[kColumns] = {tr("What is done to the scene"), tr("To what it is done"), tr("Time step of the trial"), tr("Whether it held, or which bounds it broke"),
                                  tr("Energy beyond what there was and what was put in"), tr("How deep surfaces lay in each other at most"),
                                  tr("From the end of the load until it was at rest"), tr("Elements inside out: most at once, and at the end"), tr("A failure has a picture of its end")};
  for (int column = 0; column < kColumns; ++column) m_table->horizontalHeaderItem(column)->setToolTip(tips[column]);
  m_table->setColumnWidth(kTrial, 170);
  m_table->setColumnWidth(kVerdict, 150);
  for (const Column column : {kStep, kEnergy, kDepth, kRecovery, kInsideOut, kPicture}) m_table->setColumnWidth(column, 74);
  m_table->setAccessibleName(tr("Trials of the gauntlet"));
  m_play->setText(tr("&Run it again in the view"));
  m_play->setToolTip(tr("Show the failure as it went, step for step; a double click on its row does the same"));
  m_back->setText(tr("&Back to the scene"));
  m_table->setRowCount(0);
  refresh();
  showCurrent();
}

void StabilityPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

}  // namespace glenoid
