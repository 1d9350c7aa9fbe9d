// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/lab/StudyBar.h"

#include <QComboBox>
#include <QDateTime>
#include <QDir>
#include <QEvent>
#include <QFileDialog>
#include <QHBoxLayout>
#include <QLocale>
#include <QProgressBar>
#include <QStandardPaths>
#include <QVBoxLayout>
#include <cmath>

#include "editor/core/Sentences.h"
#include "editor/lab/SettingWords.h"
#include "editor/lab/StudiedScene.h"
#include "editor/ui/PanelParts.h"

namespace glenoid {

StudyBar::StudyBar(QString kind, Document& document, const LabServices& services, QWidget* parent)
    : QWidget(parent), m_kind(std::move(kind)), m_document(document), m_services(services) {
  const auto named = [this](const char* name) { return QStringLiteral("lab.%1.%2").arg(m_kind, QLatin1String(name)); };
  m_extent = new QComboBox;
  m_extent->setObjectName(named("extent"));
  m_extent->addItems({QString(), QString()});
  m_run = new QPushButton;
  m_run->setObjectName(named("run"));
  m_stop = new QPushButton;
  m_stop->setObjectName(named("stop"));
  m_open = new QPushButton;
  m_open->setObjectName(named("open"));
  m_bar = new QProgressBar;
  m_bar->setObjectName(named("progress"));
  m_bar->setRange(0, 1000);
  m_bar->setTextVisible(false);
  m_bar->setFixedHeight(8);
  m_words = panel::words(named("words").toLatin1().constData(), "hint");
  m_sentence = panel::words(named("sentence").toLatin1().constData(), "warning");
  m_sentence->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  m_sentence->hide();
  auto* row = new QHBoxLayout;
  row->addWidget(m_extent);
  row->addWidget(m_run);
  row->addWidget(m_stop);
  row->addStretch(1);
  row->addWidget(m_open);
  auto* layout = new QVBoxLayout(this);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(4);
  layout->addLayout(row);
  layout->addWidget(m_bar);
  layout->addWidget(m_words);
  layout->addWidget(m_sentence);
  connect(m_run, &QPushButton::clicked, this, [this] { begin(); });
  connect(m_stop, &QPushButton::clicked, this, &StudyBar::stop);
  connect(m_open, &QPushButton::clicked, this, &StudyBar::askForFolder);
  connect(&m_document, &Document::changed, this, &StudyBar::refresh);
  connect(&m_process, &StudyProcess::changed, this, [this] {
    refresh();
    emit newsCame();
  });
  connect(&m_process, &StudyProcess::ended, this, [this](StudyProcess::End end, const QString& sentence) {
    say(end == StudyProcess::End::Cancelled ? tr("Stopped. What was found until then stays in its folder.") : sentence);
    refresh();
    emit newsCame();
    if (end == StudyProcess::End::Done) emit endedWell();
  });
  retranslate();
}

void StudyBar::say(const QString& sentence) {
  m_sentence->setText(sentence);
  m_sentence->setVisible(!sentence.isEmpty());
}

/// The scene's own file while that is what is open, else a copy beside what is found out.
Result<QString> StudyBar::scenarioFor(const QString& folder) const {
  const QString& path = m_document.path();
  const bool asOpened = m_document.undoStack().isClean() && (path.startsWith(u"builtin:") || path.endsWith(u".scenario.json"));
  if (asOpened && !path.contains(u"builtin:shoulder")) return path;
  const Result<std::string> saved = saveStudied(m_document.scene(), folder.toStdString(), "studied");
  if (!saved) return saved.error();
  return QString::fromStdString(*saved);
}

void StudyBar::begin() {
  const QDir root(QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/studies"));
  const QString leaf = QStringLiteral("%1-%2-%3").arg(QString::fromStdString(m_document.scenario().id), m_kind, QDateTime::currentDateTime().toString(QStringLiteral("yyyyMMdd-HHmmss")));
  begin(root.filePath(leaf));
}

void StudyBar::begin(const QString& folder) {
  if (m_process.isRunning() || m_document.isEmpty()) return;
  say({});
  if (!QDir().mkpath(folder)) return say(sentenceOf({Fault::FileUnwritable, {folder.toStdString(), {}, {}, {}}, {}, {}}));
  const Result<QString> scenario = scenarioFor(folder);
  if (!scenario) return say(sentenceOf(scenario.error()));
  m_scene = std::make_shared<const Scene>(m_document.scene());
  QStringList arguments{QStringLiteral("study"), m_kind, *scenario, QStringLiteral("--out"), folder};
  if (m_extent->currentIndex() == 0) arguments << QStringLiteral("--quick");
  if (m_more) arguments << m_more();
  m_process.start(m_services.program, arguments, folder);
  emit begun();
}

void StudyBar::openFolder(const QString& folder) {
  if (m_process.isRunning()) return;
  say({});
  m_scene = nullptr;
  if (const auto opened = m_process.open(folder); !opened) return say(tr("There is no study in %1.").arg(QDir::toNativeSeparators(folder)));
  if (study().kind() != m_kind.toStdString()) say(tr("The study in %1 is of another kind.").arg(QDir::toNativeSeparators(folder)));
  else if (!study().hasEnded()) say(tr("This study was stopped before its end."));
  emit begun();
  emit newsCame();
}

void StudyBar::askForFolder() {
  const QString folder = QFileDialog::getExistingDirectory(this, tr("Open a study"), QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/studies"));
  if (!folder.isEmpty()) openFolder(folder);
}

void StudyBar::refresh() {
  const bool runs = m_process.isRunning();
  m_run->setEnabled(!runs && !m_document.isEmpty() && !m_services.program.isEmpty());
  m_extent->setEnabled(!runs);
  m_open->setEnabled(!runs);
  m_stop->setEnabled(runs);
  m_bar->setVisible(runs);
  m_bar->setValue(static_cast<int>(std::lround(1000 * study().fraction())));
  QString words;
  if (runs) {
    const double left = m_process.secondsRemaining();
    const QString share = QLocale().toString(100 * study().fraction(), 'f', 0);
    words = left < 0 ? tr("%1 % done").arg(share)
            : left < 90 ? tr("%1 % done, about %n second(s) left", nullptr, static_cast<int>(std::ceil(left))).arg(share)
                        : tr("%1 % done, about %n minute(s) left", nullptr, static_cast<int>(std::ceil(left / 60))).arg(share);
    const std::string& what = study().what();
    if (!what.empty() && what.find('=') != std::string::npos) words += QStringLiteral(" · ") + settingWords(what);
    else if (what == "windows") words += QStringLiteral(" · ") + tr("looking for moments to compare");
    else if (what == "times") words += QStringLiteral(" · ") + tr("taking times");
    else if (what == "check of the reference") words += QStringLiteral(" · ") + tr("checking the reference");
  } else if (!study().kind().empty()) {
    words = tr("In %1").arg(QDir::toNativeSeparators(QString::fromStdString(study().path())));
  }
  m_words->setText(words);
  m_words->setVisible(!words.isEmpty());
}

void StudyBar::retranslate() {
  m_extent->setItemText(0, tr("Quick"));
  m_extent->setItemText(1, tr("Whole"));
  m_extent->setAccessibleName(tr("How thorough the study is"));
  m_extent->setToolTip(tr("Quick: a few minutes at most. Whole: up to twenty."));
  m_run->setText(tr("&Run the study"));
  m_run->setToolTip(tr("Study the scene as it stands now, in a process of its own"));
  m_stop->setText(tr("&Stop"));
  m_open->setText(tr("&Open a study…"));
  m_open->setToolTip(tr("Show a study of before from its folder"));
  m_bar->setAccessibleName(tr("How far the study is"));
  refresh();
}

void StudyBar::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

}  // namespace glenoid
