// SPDX-License-Identifier: GPL-3.0-or-later
// Surfaces from other programs, by the menu; and whatever is dropped on the window.
#include <QDragEnterEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QMimeData>
#include <QUrl>

#include "editor/ui/ImportDialog.h"
#include "editor/ui/MainWindow.h"
#include "editor/ui/SceneView.h"
#include "simcore/import/MeshFormat.h"

namespace glenoid {
namespace {

QStringList surfacesIn(const QMimeData& data) {
  QStringList files;
  for (const QUrl& url : data.urls())
    if (url.isLocalFile() && QFileInfo(url.toLocalFile()).isFile() && formatByEnding(url.toLocalFile().toStdString())) files << url.toLocalFile();
  return files;
}

/// What can be opened, where it alone is dropped: a scenario, a joint or a recorded run.
QString sceneIn(const QMimeData& data) {
  if (data.urls().size() != 1 || !data.urls().front().isLocalFile()) return {};
  const QFileInfo file(data.urls().front().toLocalFile());
  const QString path = file.absoluteFilePath();
  const bool scene = file.isDir() ? path.endsWith(u".joint") : path.endsWith(u".scenario.json") || path.endsWith(u".jointz") || path.endsWith(u".recording");
  return scene ? path : QString();
}

}  // namespace

void MainWindow::askForSurfaces() {
  QStringList patterns;
  for (const std::string& ending : importEndings()) patterns << QStringLiteral("*.") + QString::fromStdString(ending);
  const QStringList files = QFileDialog::getOpenFileNames(this, tr("Import surfaces"), {}, tr("Surfaces (%1);;All files (*)").arg(patterns.join(QLatin1Char(' '))));
  if (!files.isEmpty()) importSurfaceFiles(files);
}

void MainWindow::importSurfaceFiles(const QStringList& files) {
  if (auto* open = findChild<ImportDialog*>()) return open->addFiles(files);
  auto* dialog = new ImportDialog(m_document, files, this);
  dialog->setAttribute(Qt::WA_DeleteOnClose);
  connect(dialog, &ImportDialog::imported, this, [this](const QStringList& parts) {
    showProblem({});
    std::set<std::string> ids;
    for (const QString& part : parts) ids.insert(part.toStdString());
    m_selection.assign(ids, *ids.begin());
    if (m_view) m_view->frameAll();
  });
  dialog->open();
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
  if (!sceneIn(*event->mimeData()).isEmpty() || !surfacesIn(*event->mimeData()).isEmpty()) event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
  if (const QString scene = sceneIn(*event->mimeData()); !scene.isEmpty()) {
    event->acceptProposedAction();
    // After the drop: a question would hold the program from which it comes.
    QMetaObject::invokeMethod(this, [this, scene] { if (mayDiscard()) openScene(scene); }, Qt::QueuedConnection);
    return;
  }
  const QStringList files = surfacesIn(*event->mimeData());
  if (files.isEmpty()) return;
  event->acceptProposedAction();
  importSurfaceFiles(files);
}

}  // namespace glenoid
