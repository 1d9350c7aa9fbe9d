// SPDX-License-Identifier: GPL-3.0-or-later
// What comes back after a crash, and what goes to other programs.
#include <QDir>
#include <QFileDialog>
#include <QFileInfo>
#include <QMessageBox>

#include "simcore/scene/RecordingFile.h"
#include "editor/core/ExportSentences.h"
#include "editor/ui/ExportDialog.h"
#include "editor/core/PartMovement.h"
#include "editor/core/Sentences.h"
#include "editor/ui/MainWindow.h"
#include "editor/ui/RecoverDialog.h"

namespace glenoid {

void MainWindow::offerRecovery(const QString& autosaveRoot) {
  m_autosaveRoot = autosaveRoot;
  askForRecovery(false);
}

void MainWindow::askForRecovery(bool all) {
  std::vector<AbandonedSession> sessions;
  if (!m_autosaveRoot.isEmpty()) sessions = abandonedSessions(m_autosaveRoot);
  if (!all) std::erase_if(sessions, [](const AbandonedSession& session) { return session.declined; });
  if (sessions.empty()) {
    if (all) QMessageBox::information(this, tr("Recover unsaved work"), tr("There is no unsaved work to recover."));
    return;
  }
  RecoverDialog dialog(sessions, this);
  if (dialog.exec() != QDialog::Accepted || !dialog.chosen()) {
    for (const AbandonedSession& session : sessions) declineSession(session.folder);
    return;
  }
  if (!mayDiscard()) return;
  auto scene = loadGeneration(dialog.chosen()->folder);
  if (!scene.ok()) return showProblem(sentenceOf(scene.error()));
  m_opening = 0;  // whatever is being opened comes too late
  showProblem({});
  m_selection.clear();
  m_display.showAll();
  m_document.openUnsaved(std::move(scene).value(), dialog.chosen()->origin);
  declineSession(dialog.chosenSession()->folder);  // stays until the work is saved or thirty days have passed
  refreshRun();
  emit sceneOpened();
}

void MainWindow::newScene() {
  if (!mayDiscard()) return;
  m_opening = 0;
  showProblem({});
  m_selection.clear();
  m_display.showAll();
  m_document.open(emptyScene(tr("Untitled joint")), {});
  refreshRun();
  emit sceneOpened();
}

void MainWindow::askForStarterFolder(const std::string& kind) {
  if (!mayDiscard()) return;
  const QString folder = QFileDialog::getSaveFileName(this, tr("Make a folder for the new joint"), QString::fromStdString("my-" + kind), {}, nullptr,
                                                      QFileDialog::DontConfirmOverwrite);
  if (!folder.isEmpty()) startJointIn(folder, kind);
}

void MainWindow::startJointIn(const QString& folder, const std::string& kind) {
  if (QFileInfo::exists(folder) && !QDir(folder).isEmpty())
    return showProblem(tr("There is something in %1 already. Choose a new folder.").arg(QDir::toNativeSeparators(folder)));
  const auto always = [](const Scene&, const Scene&) { return true; };  // what is made lies in a folder of its own
  m_jobs.start<std::string>(
      tr("New joint in %1").arg(QFileInfo(folder).fileName()),
      [starter = m_starter, folder = folder.toStdString(), kind](JobContext& context) {
        return starter(kind, folder, [&context](double done) { return context.progress(done); });
      },
      [this](const std::string& scenario) {
        if (mayDiscard()) openScene(QString::fromStdString(scenario));
      },
      always);
}

void MainWindow::saveRun() {
  QString path = QFileDialog::getSaveFileName(this, tr("Save this run"), QString::fromStdString(m_document.scenario().id) + QStringLiteral(".recording"),
                                              tr("Recordings (*.recording)"));
  if (path.isEmpty()) return;
  if (!path.endsWith(u".recording", Qt::CaseInsensitive)) path += QStringLiteral(".recording");
  saveRunTo(path);
}

void MainWindow::saveRunTo(const QString& path) {
  // It names its scene by the file, so that must be what was run.
  if (m_document.path().isEmpty() || !m_document.undoStack().isClean())
    return showProblem(tr("The run belongs to a scene that is not saved. Save the scene, reset and run again; then the run can be saved."));
  m_link.askForSession([this, path, scene = m_document.path()](std::optional<Recording> recording) {
    if (!recording)
      return showProblem(tr("There is no run to be saved: nothing was run yet, or the scene was changed while it ran. Reset and run again."));
    recording->scenario = scene.toStdString();
    const auto saved = saveRecording(*recording, path.toStdString());
    showProblem(saved ? QString() : sentenceOf(saved.error()));
  });
}

void MainWindow::exportTo() {
  QStringList filters;
  for (const ExportFormat format : kExportFormats)
    filters << QStringLiteral("%1 (*.%2)").arg(exportName(format), QLatin1String(exportWord(format)));
  QString chosen, path = QFileDialog::getSaveFileName(this, tr("Export the joint"), QString::fromStdString(m_document.joint().id),
                                                      filters.join(QStringLiteral(";;")), &chosen);
  if (path.isEmpty()) return;
  // The ending decides; where none was typed, the filter does.
  const auto formatOf = [&](const QString& ending) -> const ExportFormat* {
    for (const ExportFormat& format : kExportFormats)
      if (ending.compare(QLatin1String(exportWord(format)), Qt::CaseInsensitive) == 0) return &format;
    return nullptr;
  };
  const ExportFormat* format = formatOf(QFileInfo(path).suffix());
  if (!format) {
    format = &kExportFormats[std::max<qsizetype>(0, filters.indexOf(chosen))];
    path += QLatin1Char('.') + QLatin1String(exportWord(*format));
  }
  if (!holdsVolumes(*format)) return exportJointTo(path, *format, {});
  auto* dialog = new ExportDialog(*format, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &QDialog::accepted, this, [this, dialog, path, format = *format] { exportJointTo(path, format, dialog->wish()); });
  dialog->open();
}

void MainWindow::exportJointTo(const QString& path, ExportFormat format, ExportWish wish) {
  const auto always = [](const Scene&, const Scene&) { return true; };  // what is exported is the joint as it was when asked
  m_jobs.start<ExportReport>(
      tr("Export %1").arg(QFileInfo(path).fileName()),
      [joint = m_document.joint(), path, format, wish](JobContext& context) mutable {
        wish.stop = &context.cancelled();
        return exportJoint(joint, format, path.toStdString(), wish);
      },
      [this, path, mesh = wish.mesh](const ExportReport& report) {
        QStringList solids, losses;
        for (const SolidFigures& solid : report.solids) solids << QStringLiteral("<li>%1</li>").arg(sentenceOf(solid, mesh).toHtmlEscaped());
        for (const Loss& loss : report.losses) losses << QStringLiteral("<li>%1</li>").arg(sentenceOf(loss).toHtmlEscaped());
        auto* box = new QMessageBox(QMessageBox::Information, tr("Export"), tr("The joint was written to %1.").arg(path.toHtmlEscaped()),
                                    QMessageBox::Ok, this);
        box->setObjectName(QStringLiteral("exported"));
        box->setTextFormat(Qt::RichText);
        QString more;
        if (!solids.isEmpty()) more += QStringLiteral("<ul>%1</ul>").arg(solids.join(QString()));
        if (!losses.isEmpty()) more += tr("<p>What the file does not hold:</p><ul>%1</ul>").arg(losses.join(QString()));
        box->setInformativeText(more);
        box->setAttribute(Qt::WA_DeleteOnClose);
        box->open();
      },
      always);
}

}  // namespace glenoid
