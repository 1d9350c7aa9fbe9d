// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QMainWindow>

#include "editor/core/DisplayState.h"
#include "editor/core/Document.h"
#include "editor/core/FieldView.h"
#include "editor/core/JobSystem.h"
#include "editor/core/PlayLink.h"
#include "editor/core/ProblemWatch.h"
#include "editor/lab/LabServices.h"
#include "editor/ui/Actions.h"
#include "editor/ui/GlProbe.h"
#include "simcore/export/ExportJoint.h"

class QDockWidget;
class QLabel;
class QMenu;
class QToolBar;

namespace glenoid {

class AuthorDocks;
class LabDocks;
class LayersPanel;
class PartTree;
class PropertiesPanel;
class SceneView;
class StatusFigures;
class TasksPanel;
class ToolPanel;
class Workspaces;

/// Makes a small joint to begin with in a new folder (`kind`: of starterKinds) and answers the path of its scenario; comes from the
/// application. `goOn` gets how much is done, 0…1, and ends it with Cancelled when it answers false. May run on any thread.
using SceneStarter = std::function<Result<std::string>(const std::string& kind, const std::string& folder, const std::function<bool(double)>& goOn)>;

/// The window: puts views and actions together, decides nothing. It owns none of the four below, which must
/// outlive it. Loading and saving come from the application.
class MainWindow : public QMainWindow {
  Q_OBJECT
 public:
  struct Parts {
    Document& document;
    PlayLink& link;
    DisplayState& display;
    Selection& selection;
  };

  /// Without a starter no joint is begun from a template; without the lab's services no study is run.
  MainWindow(const Parts& parts, const GlProbe& graphics, SceneLoader loader, SceneSaver saver, SceneStarter starter = {}, LabServices lab = {});
  ~MainWindow() override;

  SceneView* view() const { return m_view; }  ///< null without OpenGL
  Actions& actions() { return m_actions; }
  /// Work in the background, shown in the status bar.
  JobSystem& jobs() { return m_jobs; }
  ProblemWatch& problems() { return m_problems; }
  AuthorDocks& author() { return *m_author; }
  LabDocks& lab() { return *m_lab; }
  Workspaces& workspaces() { return *m_workspaces; }
  FieldView& field() { return m_field; }
  TasksPanel& tasks() { return *m_tasks; }
  /// Reads a scene on a worker and shows it; a problem becomes a sentence above the view.
  void openScene(const QString& path);
  void showProblem(const QString& sentence);
  /// Makes a joint to begin with in a new folder, in the background, and opens it.
  void startJointIn(const QString& folder, const std::string& kind);
  /// Opens the dialog that looks at files of surfaces; adds them to it where it is open already.
  void importSurfaceFiles(const QStringList& files);
  /// Where safety copies lie; offers at once what a program that was killed left there.
  void offerRecovery(const QString& autosaveRoot);
  /// Writes what hands did in this run as a recording, which `glenoid replay` repeats to the last bit; says why where it cannot.
  void saveRunTo(const QString& path);
  /// Writes the joint for another program in the background, then says what was lost.
  void exportJointTo(const QString& path, ExportFormat format, ExportWish wish);

 signals:
  void languageWanted(const QString& code);
  void themeWanted(bool dark);
  void sceneOpened();

 protected:
  bool eventFilter(QObject* watched, QEvent* event) override;
  bool focusNextPrevChild(bool next) override;
  void changeEvent(QEvent* event) override;
  void closeEvent(QCloseEvent* event) override;
  void dragEnterEvent(QDragEnterEvent* event) override;
  void dropEvent(QDropEvent* event) override;

 private:
  void makeFileActions();
  void makeEditActions();
  void makeViewActions();
  void makeColourActions();
  void makeScopeActions();
  void makeSimulationActions();
  void makeMenus();
  void makeToolBars();
  void makeDocks();
  void makeDocumentDocks();
  void makeLab(LabServices services);
  QWidget* makeCentre(const GlProbe& graphics);
  void retranslate();
  void refreshTitle();
  void refreshRun();
  bool mayDiscard();
  void newScene();
  void askForScene();
  void askForJointFolder();
  void askForStarterFolder(const std::string& kind);
  void askForSurfaces();
  void askForRecovery(bool all);
  void save();
  void saveAs();
  void saveTo(const QString& path);
  void nameInnerButtons();
  void exportPicture();
  void saveRun();
  void exportTo();
  void showAbout();

  Document& m_document;
  PlayLink& m_link;
  DisplayState& m_display;
  Selection& m_selection;
  SceneLoader m_loader;
  SceneSaver m_saver;
  SceneStarter m_starter;
  Actions m_actions;
  JobSystem m_jobs;
  ProblemWatch m_problems;
  FieldView m_field;
  SceneView* m_view = nullptr;
  AuthorDocks* m_author = nullptr;
  LabDocks* m_lab = nullptr;
  Workspaces* m_workspaces = nullptr;
  PartTree* m_tree = nullptr;
  LayersPanel* m_layers = nullptr;
  PropertiesPanel* m_properties = nullptr;
  TasksPanel* m_tasks = nullptr;
  ToolPanel* m_tools = nullptr;
  StatusFigures* m_figures = nullptr;
  QLabel *m_problem = nullptr, *m_noGraphics = nullptr, *m_busy = nullptr;
  QWidget* m_banner = nullptr;
  std::vector<QMenu*> m_menus;
  std::vector<QDockWidget*> m_docks;
  QMenu *m_languageMenu = nullptr, *m_solverMenu = nullptr, *m_sideMenu = nullptr, *m_builtinMenu = nullptr, *m_starterMenu = nullptr, *m_colourMenu = nullptr;
  std::vector<QToolBar*> m_toolBars;
  QThreadPool m_workers;
  QString m_autosaveRoot;
  int m_opening = 0, m_openings = 0;  ///< the one under way (0: none), and how many so far
};

}  // namespace glenoid
