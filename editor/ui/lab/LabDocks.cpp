// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/lab/LabDocks.h"

#include <QDir>
#include <QDockWidget>
#include <QFileDialog>
#include <QMainWindow>

#include "editor/ui/Language.h"
#include "editor/ui/SceneView.h"
#include "editor/ui/lab/AccuracyPanel.h"
#include "editor/ui/lab/EffectsPanel.h"
#include "editor/ui/lab/StabilityPanel.h"
#include "editor/ui/lab/StudyBar.h"

namespace glenoid {

LabDocks::LabDocks(QMainWindow& window, Actions& actions, Document& document, PlayLink& link, JobSystem& jobs, SceneView* view, LabServices services)
    : QObject(&window), m_window(window), m_services(std::move(services)) {
  m_accuracy = new AccuracyPanel(document, link, jobs, m_services);
  m_stability = new StabilityPanel(document, link, jobs, m_services);
  m_effects = new EffectsPanel(document, link);
  if (view) m_accuracy->setViewSource([view] { return view->view(); });
  addDock("lab.accuracy", m_accuracy);
  addDock("lab.stability", m_stability);
  addDock("lab.effects", m_effects);
  // A panel behind another's tab is shown to Qt and seen by nobody; its dock knows.
  connect(m_docks.back(), &QDockWidget::visibilityChanged, m_effects, &EffectsPanel::setWatched);
  m_report.setStandardOutputFile(QProcess::nullDevice());
  connect(&m_report, &QProcess::finished, this, [this](int status) {
    if (status == 0) return emit reportWritten(m_report.property("file").toString());
    const QString said = QString::fromUtf8(m_report.readAllStandardError()).trimmed().section(u'\n', -1);
    emit problem(said.isEmpty() ? tr("The report could not be written.") : said);
  });
  actions.add("report", {}, {}, [] { return Actions::Words{tr("&Report of the studies…"), tr("Write the studies that the lab shows as one document, HTML or PDF")}; }, [this] { askForReport(); });
}

LabDocks::~LabDocks() {
  m_report.disconnect(this);
  m_report.kill();
  m_report.waitForFinished(1000);
}

void LabDocks::addDock(const char* name, QWidget* content) {
  auto* made = new QDockWidget(&m_window);
  made->setObjectName(QStringLiteral("dock.") + QLatin1String(name));
  made->setWidget(content);
  made->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable | QDockWidget::DockWidgetFloatable);
  m_window.addDockWidget(Qt::RightDockWidgetArea, made);
  if (!m_docks.empty()) m_window.tabifyDockWidget(m_docks.front(), made);
  made->hide();
  m_docks.push_back(made);
}

QStringList LabDocks::dockNames() const {
  QStringList names;
  for (const QDockWidget* dock : m_docks) names << dock->objectName();
  return names;
}

QStringList LabDocks::studies() const {
  QStringList folders;
  for (const StudyBar* bar : {&m_accuracy->bar(), &m_stability->bar()})
    if (!bar->study().kind().empty()) folders << QString::fromStdString(bar->study().path());
  return folders;
}

void LabDocks::askForReport() {
  if (studies().isEmpty()) return emit problem(tr("There is no study to report on. Run one in the lab, or open one there."));
  QString chosen;
  const QString html = tr("Web page (*.html)"), pdf = tr("PDF (*.pdf)");
  QString file = QFileDialog::getSaveFileName(&m_window, tr("Write the report"), QStringLiteral("report.html"), html + QStringLiteral(";;") + pdf, &chosen);
  if (file.isEmpty()) return;
  if (!file.endsWith(u".html", Qt::CaseInsensitive) && !file.endsWith(u".pdf", Qt::CaseInsensitive)) file += chosen == pdf ? QStringLiteral(".pdf") : QStringLiteral(".html");
  writeReport(file);
}

void LabDocks::writeReport(const QString& file) {
  if (m_report.state() != QProcess::NotRunning) return emit problem(tr("A report is being written already."));
  m_report.setProperty("file", file);
  m_report.start(m_services.program, QStringList{QStringLiteral("study"), QStringLiteral("report")} + studies() +
                                         QStringList{QStringLiteral("--out"), file, QStringLiteral("--language"), currentLanguage()});
}

void LabDocks::stopStudies() {
  m_accuracy->bar().stop();
  m_stability->bar().stop();
  m_accuracy->pictures().stop();
}

void LabDocks::retranslate() {
  const QStringList titles = {tr("Accuracy"), tr("Stability"), tr("Effects")};
  for (std::size_t k = 0; k < m_docks.size(); ++k) m_docks[k]->setWindowTitle(titles.value(static_cast<int>(k)));
}

}  // namespace glenoid
