// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/lab/StudyProcess.h"

#include <signal.h>
#include <sys/prctl.h>

#include <QDir>
#include <QFile>

#include "editor/core/Sentences.h"

namespace glenoid {

StudyProcess::StudyProcess(QObject* parent) : QObject(parent) {
  // A program that is killed cannot clean up; its study would run on for minutes.
  m_process.setChildProcessModifier([] { prctl(PR_SET_PDEATHSIG, SIGKILL); });
  m_process.setStandardOutputFile(QProcess::nullDevice());
  m_look.setInterval(200);
  connect(&m_look, &QTimer::timeout, this, &StudyProcess::look);
  connect(&m_process, &QProcess::finished, this, &StudyProcess::finish);
  connect(&m_process, &QProcess::errorOccurred, this, [this](QProcess::ProcessError error) {
    if (error != QProcess::FailedToStart) return;
    m_look.stop();
    emit ended(End::Failed, tr("The study could not be started: %1 cannot be run.").arg(m_process.program()));
  });
}

StudyProcess::~StudyProcess() {
  m_process.disconnect(this);
  if (!isRunning()) return;
  m_process.kill();
  m_process.waitForFinished(3000);
}

void StudyProcess::start(const QString& program, const QStringList& arguments, const QString& folder) {
  QFile::remove(QDir(folder).filePath(QStringLiteral("progress.jsonl")));  // of a study before
  m_study = StudyFolder(folder.toStdString());
  m_cancelled = false;
  m_remaining = -1;
  m_clock.start();
  m_process.start(program, arguments, QIODevice::ReadOnly);
  m_look.start();
  emit changed();
}

void StudyProcess::cancel() {
  if (!isRunning()) return;
  m_cancelled = true;
  m_process.kill();  // it holds nothing but files that are each written whole
}

Result<Done> StudyProcess::open(const QString& folder) {
  Result<StudyFolder> opened = StudyFolder::open(folder.toStdString());
  if (!opened) return opened.error();
  m_study = std::move(*opened);
  emit changed();
  return Done{};
}

double StudyProcess::secondsRemaining() const { return isRunning() ? m_remaining : -1; }

void StudyProcess::look() {
  m_study.look();
  const double done = m_study.fraction(), elapsed = 1e-3 * static_cast<double>(m_clock.elapsed());
  m_remaining = done > 0.02 && elapsed > 2 ? elapsed * (1 - done) / done : -1;
  emit changed();
}

void StudyProcess::finish(int status, QProcess::ExitStatus how) {
  m_look.stop();
  m_study.look();
  emit changed();
  if (m_cancelled) return emit ended(End::Cancelled, {});
  const QString said = QString::fromUtf8(m_process.readAllStandardError()).trimmed().section(u'\n', -1);
  if (how == QProcess::CrashExit)
    return emit ended(End::Failed, tr("The study broke off: its process ended by itself. What it had found is kept in %1.").arg(QString::fromStdString(m_study.path())));
  if (status == 0) return emit ended(End::Done, {});
  const QString sentence = m_study.error() ? sentenceOf(*m_study.error())  // in the window's language
                           : said.isEmpty() ? tr("The study ended with the exit status %1 and did not say why.").arg(status)
                                            : said;
  emit ended(status == 1 && m_study.isWhole() ? End::Done : End::Failed, sentence);
}

}  // namespace glenoid
