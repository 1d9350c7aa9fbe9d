// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/MainWindow.h"

#include <QAbstractButton>
#include <QApplication>
#include <QAbstractItemView>
#include <QComboBox>
#include <QKeyEvent>
#include <QCloseEvent>
#include <QDockWidget>
#include <QHBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QMenu>
#include <QMessageBox>
#include <QStatusBar>
#include <QToolBar>
#include <QToolButton>
#include <QVBoxLayout>

#include "editor/core/Sentences.h"
#include "editor/ui/AuthorDocks.h"
#include "editor/ui/FieldPanel.h"
#include "editor/ui/HistoryPanel.h"
#include "editor/ui/JobsBar.h"
#include "editor/ui/LayersPanel.h"
#include "editor/ui/NoticeStrip.h"
#include "editor/ui/PartTree.h"
#include "editor/ui/ProblemsPanel.h"
#include "editor/ui/PropertiesPanel.h"
#include "editor/ui/SceneView.h"
#include "editor/ui/StatusFigures.h"
#include "editor/ui/ToolPanel.h"
#include "editor/ui/Workspaces.h"
#include "editor/ui/lab/LabDocks.h"
#include "editor/ui/training/TasksPanel.h"

namespace glenoid {

MainWindow::MainWindow(const Parts& parts, const GlProbe& graphics, SceneLoader loader, SceneSaver saver, SceneStarter starter, LabServices lab)
    : m_document(parts.document), m_link(parts.link), m_display(parts.display), m_selection(parts.selection),
      m_loader(std::move(loader)), m_saver(std::move(saver)), m_starter(std::move(starter)), m_actions(this), m_jobs(m_document),
      m_problems(m_document, m_jobs), m_field(m_link) {
  qApp->installEventFilter(this);
  setObjectName(QStringLiteral("mainWindow"));
  m_workers.setMaxThreadCount(1);
  setAcceptDrops(true);
  setDockOptions(AnimatedDocks | AllowTabbedDocks | AllowNestedDocks);
  setCentralWidget(makeCentre(graphics));
  makeDocks();
  makeFileActions();
  makeEditActions();
  makeViewActions();
  makeColourActions();
  makeScopeActions();
  makeSimulationActions();
  m_author = new AuthorDocks(*this, m_actions, m_document, m_jobs, m_display, m_selection, m_view);
  makeLab(std::move(lab));
  makeMenus();
  makeToolBars();

  m_busy = new QLabel;
  m_busy->setObjectName(QStringLiteral("busy"));
  m_busy->setContentsMargins(8, 0, 8, 0);
  statusBar()->addWidget(m_busy);
  statusBar()->addWidget(new JobsBar(m_jobs));
  connect(&m_jobs, &JobSystem::ended, this, [this](int, JobSystem::End, const QString& sentence) {
    if (!sentence.isEmpty()) showProblem(sentence);
  });
  m_figures = new StatusFigures(m_link);
  if (m_view) m_figures->setFramesPerSecond([this] { return m_view->framesPerSecond(); });
  statusBar()->addPermanentWidget(m_figures);

  connect(&m_document, &Document::changed, this, [this] { refreshTitle(); });
  connect(&m_document.undoStack(), &QUndoStack::cleanChanged, this, [this] { refreshTitle(); });
  connect(&m_document.undoStack(), &QUndoStack::indexChanged, this, [this] { refreshRun(); });
  connect(&m_link, &PlayLink::snapshotChanged, this, &MainWindow::refreshRun);
  connect(&m_link, &PlayLink::compilingChanged, this, &MainWindow::refreshRun);
  connect(&m_link, &PlayLink::guestChanged, this, &MainWindow::refreshRun);
  connect(&m_link, &PlayLink::problem, this, [this](const Error& error) { showProblem(sentenceOf(error)); });
  connect(&m_link, &PlayLink::compiled, this, [this] { showProblem({}); });
  retranslate();
  resize(1440, 900);
}

MainWindow::~MainWindow() {
  if (m_view) m_view->setField(nullptr);  // the view goes after the members
  m_workers.clear();
  m_workers.waitForDone();
}

// ---- Widgets

QWidget* MainWindow::makeCentre(const GlProbe& graphics) {
  auto* centre = new QWidget;
  auto* layout = new QVBoxLayout(centre);
  layout->setContentsMargins(0, 0, 0, 0);
  layout->setSpacing(0);
  m_banner = new QWidget;
  m_banner->setProperty("role", QStringLiteral("banner"));
  m_banner->setAttribute(Qt::WA_StyledBackground);
  auto* row = new QHBoxLayout(m_banner);
  row->setContentsMargins(0, 0, 4, 0);
  m_problem = new QLabel;
  m_problem->setObjectName(QStringLiteral("problem"));
  m_problem->setProperty("role", QStringLiteral("problem"));
  m_problem->setWordWrap(true);
  m_problem->setTextInteractionFlags(Qt::TextSelectableByMouse);
  auto* close = new QToolButton;
  close->setObjectName(QStringLiteral("closeProblem"));
  close->setText(QStringLiteral("✕"));
  connect(close, &QToolButton::clicked, this, [this] { showProblem({}); });
  row->addWidget(m_problem, 1);
  row->addWidget(close);
  m_banner->hide();
  layout->addWidget(m_banner);
  auto* notices = new NoticeStrip(m_document, m_link);
  connect(notices, &NoticeStrip::allWanted, this, [this] {
    auto* dock = findChild<QDockWidget*>(QStringLiteral("dock.problems"));
    dock->show();
    dock->raise();
  });
  layout->addWidget(notices);
  if (graphics.usable) {
    m_view = new SceneView(m_link, m_display, m_selection, graphics.software);
    connect(m_view, &SceneView::graphicsFailed, this, [this](const Error& error) { showProblem(sentenceOf(error)); });
    m_view->setField(&m_field);
    layout->addWidget(m_view, 1);
  } else {
    m_noGraphics = new QLabel;
    m_noGraphics->setObjectName(QStringLiteral("noGraphics"));
    m_noGraphics->setAlignment(Qt::AlignCenter);
    m_noGraphics->setWordWrap(true);
    m_noGraphics->setMinimumSize(320, 240);
    layout->addWidget(m_noGraphics, 1);
  }
  return centre;
}

void MainWindow::makeDocks() {
  m_tree = new PartTree(m_document, m_display, m_selection);
  m_layers = new LayersPanel(m_display);
  m_properties = new PropertiesPanel(m_document, m_selection, m_link);
  m_tools = new ToolPanel(m_document, m_link);
  const auto dock = [this](const char* name, QWidget* content, Qt::DockWidgetArea area) {
    auto* made = new QDockWidget;
    made->setObjectName(QStringLiteral("dock.") + QLatin1String(name));
    made->setWidget(content);
    made->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable |
                      QDockWidget::DockWidgetFloatable);
    addDockWidget(area, made);
    m_docks.push_back(made);
  };
  setTabPosition(Qt::RightDockWidgetArea, QTabWidget::East);  // along the side there is room for all their names
  dock("parts", m_tree, Qt::LeftDockWidgetArea);
  auto* looks = new QWidget;
  auto* column = new QVBoxLayout(looks);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(m_layers);
  column->addWidget(new FieldPanel(m_field));
  column->addStretch(1);
  dock("layers", looks, Qt::LeftDockWidgetArea);
  dock("properties", m_properties, Qt::RightDockWidgetArea);
  dock("tools", m_tools, Qt::RightDockWidgetArea);
  resizeDocks({m_docks[0], m_docks[1]}, {560, 190}, Qt::Vertical);
  resizeDocks({m_docks[2], m_docks[3]}, {520, 230}, Qt::Vertical);
  resizeDocks({m_docks[0], m_docks[2]}, {270, 300}, Qt::Horizontal);
  makeDocumentDocks();
  if (m_view) {
    connect(m_tools, &ToolPanel::chosen, m_view, &SceneView::setChosenTool);
    connect(m_view, &SceneView::chosenToolChanged, m_tools, &ToolPanel::setChosen);
  }
}

/// Problems and history, in tabs behind the properties.
void MainWindow::makeDocumentDocks() {
  auto* problems = new ProblemsPanel(m_document, m_problems, m_link);
  connect(problems, &ProblemsPanel::showWanted, this, [this](const std::set<std::string>& parts) {
    if (parts.empty()) return;
    m_selection.assign(parts, *parts.begin());
    if (m_view) m_view->frameSelection();
  });
  const auto dock = [this](const char* name, QWidget* content) {
    auto* made = new QDockWidget;
    made->setObjectName(QStringLiteral("dock.") + QLatin1String(name));
    made->setWidget(content);
    addDockWidget(Qt::RightDockWidgetArea, made);
    tabifyDockWidget(m_docks[2], made);
    m_docks.push_back(made);
  };
  dock("problems", problems);
  dock("history", new HistoryPanel(m_document.undoStack()));
  m_tasks = new TasksPanel(m_document, m_link);
  dock("tasks", m_tasks);
  connect(m_tasks, &TasksPanel::showWanted, this, [this](const std::set<std::string>& parts) { m_selection.assign(parts, *parts.begin()); });
  connect(m_tasks, &TasksPanel::tasksAppeared, m_docks.back(), [shown = m_docks.back()] {
    shown->show();
    shown->raise();
  });
  m_docks[2]->raise();
}

/// The lab, and what each workspace shows.
void MainWindow::makeLab(LabServices services) {
  m_lab = new LabDocks(*this, m_actions, m_document, m_link, m_jobs, m_view, std::move(services));
  connect(m_lab, &LabDocks::problem, this, &MainWindow::showProblem);
  connect(m_lab, &LabDocks::reportWritten, this, [this](const QString& file) { statusBar()->showMessage(tr("The report is in %1").arg(file), 20000); });
  m_workspaces = new Workspaces(*this, m_actions);
  QStringList author;
  for (const std::vector<QDockWidget*>& docks : {std::vector(m_docks.begin() + 2, m_docks.end()), std::vector(m_docks.begin(), m_docks.begin() + 2), m_author->docks()})
    for (const QDockWidget* dock : docks) author << dock->objectName();
  author << m_author->toolBar()->objectName();
  m_workspaces->add({QStringLiteral("author"), [] { return Actions::Words{tr("&Author"), tr("Show what joints and scenes are made with")}; },
                     QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_1), author, 0});
  m_workspaces->add({QStringLiteral("lab"), [] { return Actions::Words{tr("&Lab"), tr("Show what accuracy costs, what stays stable and what each effect costs")}; },
                     QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_2), m_lab->dockNames(), 660});
}

// ---- Texts

/// Buttons that Qt puts into tables and fields by itself have no name, which a screen reader would miss.
void MainWindow::nameInnerButtons() {
  for (QAbstractButton* button : findChildren<QAbstractButton*>()) {
    const QLatin1String kind(button->metaObject()->className());
    if (kind == QLatin1String("QTableCornerButton")) button->setAccessibleName(tr("Select the whole table"));
    if (kind == QLatin1String("QLineEditIconButton")) button->setAccessibleName(tr("Empty the field"));
  }
}

void MainWindow::retranslate() {
  nameInnerButtons();
  setLocale(QLocale());  // fields for numbers follow the language
  m_actions.retranslate();
  const QStringList menus = {tr("&File"), tr("&Edit"), tr("&View"), tr("&Simulate"), tr("&Help")};
  for (std::size_t i = 0; i < m_menus.size(); ++i) m_menus[i]->setTitle(menus.value(static_cast<int>(i)));
  const QStringList docks = {tr("Parts"), tr("Layers"), tr("Properties"), tr("Tools"), tr("Problems"), tr("History"), tr("Tasks")};
  for (std::size_t i = 0; i < m_docks.size(); ++i) m_docks[i]->setWindowTitle(docks.value(static_cast<int>(i)));
  m_author->retranslate();
  m_lab->retranslate();
  m_workspaces->menu()->setTitle(tr("&Workspace"));
  m_builtinMenu->setTitle(tr("Open a &built-in scene"));
  if (m_starterMenu) m_starterMenu->setTitle(tr("New joint from a &template"));
  m_languageMenu->setTitle(tr("&Language"));
  m_solverMenu->setTitle(tr("S&olver"));
  m_sideMenu->setTitle(tr("Look &from"));
  m_colourMenu->setTitle(tr("&Colours by"));
  const QStringList bars = {tr("File and view"), tr("Simulation")};
  for (std::size_t i = 0; i < m_toolBars.size(); ++i) m_toolBars[i]->setWindowTitle(bars.value(static_cast<int>(i)));
  if (m_noGraphics) m_noGraphics->setText(sentenceOf({Fault::NoGraphics, {}, {}, {}}));
  if (m_view) m_view->setAccessibleName(tr("3D view of the joint"));
  if (auto* close = findChild<QToolButton*>(QStringLiteral("closeProblem"))) {
    close->setAccessibleName(tr("Close the message"));
    close->setToolTip(tr("Close the message"));
  }
  refreshTitle();
  refreshRun();
}

void MainWindow::refreshTitle() {
  const Scenario& scenario = m_document.scenario();
  const std::string& name = scenario.name.empty() ? m_document.joint().name : scenario.name;
  const bool dirty = !m_document.undoStack().isClean();
  setWindowModified(dirty);
  setWindowTitle(name.empty() ? tr("Glenoid Studio")
                              : tr("%1[*] — Glenoid Studio").arg(QString::fromStdString(name)));
}

void MainWindow::refreshRun() {
  const Snapshot& snapshot = m_link.snapshot();
  const bool ready = snapshot.model != nullptr, open = !m_document.isEmpty();
  QAction* play = m_actions[QStringLiteral("play")];
  if (play->isChecked() != snapshot.playing) play->setChecked(snapshot.playing);
  for (const char* id : {"play", "step", "reset"}) m_actions[QLatin1String(id)]->setEnabled(ready);
  for (const char* id : {"save", "saveAs", "exportJoint", "picture", "mirrorJoint"}) m_actions[QLatin1String(id)]->setEnabled(open);
  const QString busy = m_opening > 0            ? tr("Opening the scene…")
                       : m_link.isCompiling()   ? tr("Preparing the simulation…")
                       : !open                  ? tr("No scene is open")
                       : snapshot.rejectedSteps ? tr("%n step(s) could not be taken; the last good state was kept", nullptr,
                                                     static_cast<int>(snapshot.rejectedSteps))
                       : m_link.hasGuest()      ? tr("Showing a failure of a study in place of the scene")
                       : snapshot.playing       ? tr("Running")
                                                : tr("Paused");
  if (m_busy && m_busy->text() != busy) m_busy->setText(busy);
}

void MainWindow::showProblem(const QString& sentence) {
  m_problem->setText(sentence);
  m_banner->setVisible(!sentence.isEmpty());
}

// ---- Files

void MainWindow::openScene(const QString& path) {
  m_opening = ++m_openings;
  refreshRun();
  m_workers.clear();
  m_workers.start([this, number = m_opening, path, loader = m_loader] {
    auto scene = loader(path.toStdString());
    QMetaObject::invokeMethod(
        this,
        [this, number, path, scene = std::move(scene)]() mutable {
          if (number != m_opening) return;  // another one was asked for meanwhile
          m_opening = 0;
          if (scene.ok()) {
            showProblem({});
            m_selection.clear();
            m_display.showAll();
            // What was recorded belongs to its scene's file, not to the recording's.
            const bool recorded = path.endsWith(u".recording") && scene->input;
            const QString own = recorded ? QString::fromStdString(scene->input->scenario) : path;
            m_document.open(std::move(scene).value(), own);
          } else {
            showProblem(sentenceOf(scene.error()));
          }
          refreshRun();
          emit sceneOpened();
        },
        Qt::QueuedConnection);
  });
}

/// Space belongs to the button, box or list that has the focus, as everywhere; elsewhere it plays.
bool MainWindow::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto* key = static_cast<QKeyEvent*>(event);
    auto* widget = qobject_cast<QWidget*>(watched);
    const bool takes = qobject_cast<QAbstractButton*>(watched) || qobject_cast<QAbstractItemView*>(watched) || qobject_cast<QComboBox*>(watched);
    if (key->key() == Qt::Key_Space && key->modifiers() == Qt::NoModifier && takes && widget->window() == this) {
      event->accept();
      return true;
    }
  }
  return QMainWindow::eventFilter(watched, event);
}

/// Tab stops only where somebody can see it: not in panels that lie behind another's tab.
bool MainWindow::focusNextPrevChild(bool next) {
  QWidget* const before = focusWidget();
  for (int tries = 0; tries < 1000; ++tries) {
    if (!QMainWindow::focusNextPrevChild(next)) return false;
    QWidget* const now = focusWidget();
    if (!now || now == before || !now->visibleRegion().isEmpty()) return true;
  }
  return true;
}

bool MainWindow::mayDiscard() {
  if (m_document.undoStack().isClean()) return true;
  const auto answer = QMessageBox::question(
      this, tr("Unsaved changes"), tr("The scene has changes that are not saved. Save them before going on?"),
      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, QMessageBox::Save);
  if (answer == QMessageBox::Save) {
    save();
    return m_document.undoStack().isClean();
  }
  return answer == QMessageBox::Discard;
}

void MainWindow::closeEvent(QCloseEvent* event) {
  if (!mayDiscard()) {
    event->ignore();
    return;
  }
  m_link.pause();
  m_lab->stopStudies();
  QMainWindow::closeEvent(event);
}

void MainWindow::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange && !m_menus.empty()) retranslate();
  QMainWindow::changeEvent(event);
}

}  // namespace glenoid
