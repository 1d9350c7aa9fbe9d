// SPDX-License-Identifier: GPL-3.0-or-later
// What the window can do, and where it is found: actions, menus, toolbars, dialogs.
#include <QStatusBar>
#include <QFileInfo>
#include <QDir>
#include <QActionGroup>
#include <QDockWidget>
#include <QFileDialog>
#include <QLabel>
#include <QMenu>
#include <QMenuBar>
#include <QMessageBox>
#include <QToolBar>
#include <QToolButton>
#include <algorithm>

#include "editor/core/FieldText.h"
#include "editor/core/JointEdits.h"
#include "editor/core/PartEdits.h"
#include "editor/core/Sentences.h"
#include "editor/ui/AuthorDocks.h"
#include "editor/ui/Language.h"
#include "editor/ui/LayersPanel.h"
#include "editor/ui/MainWindow.h"
#include "editor/ui/SceneView.h"
#include "editor/ui/Theme.h"
#include "editor/ui/Workspaces.h"
#include "editor/ui/lab/LabDocks.h"
#include "editor/ui/Workspaces.h"
#include "editor/ui/lab/LabDocks.h"
#include "simcore/starter/Starter.h"

namespace glenoid {
namespace {

using Keys = QList<QKeySequence>;

Keys keypad(Qt::Key key, Qt::KeyboardModifiers modifiers = {}) {
  return {QKeySequence(QKeyCombination(modifiers | Qt::KeypadModifier, key))};
}

QString starterTitle(const std::string& kind) {
  if (kind == "elbow") return MainWindow::tr("&Elbow");
  if (kind == "knee") return MainWindow::tr("&Knee");
  return QString::fromStdString(kind);
}

constexpr const char* kBuiltins[] = {"builtin:arthroscopy", "builtin:arthroscopy-full", "builtin:palpation", "builtin:tour", "builtin:landmarks", "builtin:shoulder"};

}  // namespace

void MainWindow::makeFileActions() {
  m_actions.add("new", {}, {QKeySequence::New},
                [] { return Actions::Words{tr("&New joint"), tr("Begin a joint without parts; bring surfaces in then")}; },
                [this] { newScene(); });
  for (const StarterKind& kind : m_starter ? starterKinds() : std::span<const StarterKind>()) {
    m_actions.add(QStringLiteral("starter.") + QLatin1String(kind.name), {}, {}, [name = std::string(kind.name)] {
      return Actions::Words{starterTitle(name), tr("Make a small joint with recipe, scenario and meshes, to be edited")};
    }, [this, name = std::string(kind.name)] { askForStarterFolder(name); });
  }
  m_actions.add("open", "open", {QKeySequence::Open},
                [] { return Actions::Words{tr("&Open…"), tr("Open a scenario, a joint packed in one file, or a recorded run")}; }, [this] { askForScene(); });
  m_actions.add("openJoint", {}, {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_O)},
                [] { return Actions::Words{tr("Open a &joint…"), tr("Open a .joint folder")}; },
                [this] { askForJointFolder(); });
  m_actions.add("import", {}, {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_I)},
                [] { return Actions::Words{tr("&Import surfaces…"), tr("Bring in surface meshes of other programs")}; },
                [this] { askForSurfaces(); });
  for (const char* name : kBuiltins) {
    m_actions.add(QLatin1String(name), {}, {}, [name] {
      const QString id = QLatin1String(name);
      const QString text = id.endsWith(u"arthroscopy")        ? tr("&Arthroscopy of the shoulder")
                           : id.endsWith(u"arthroscopy-full") ? tr("Arthroscopy with &capsule and ligaments")
                           : id.endsWith(u"palpation")        ? tr("&Palpation of the shoulder")
                           : id.endsWith(u"tour")             ? tr("&Tour of the shoulder, with tasks")
                           : id.endsWith(u"landmarks")        ? tr("&Landmarks by palpation, with tasks")
                                                              : tr("The &shoulder alone");
      return Actions::Words{text, tr("Open a scene that ships with the program")};
    }, [this, name] {
      if (mayDiscard()) openScene(QLatin1String(name));
    });
  }
  m_actions.add("recover", {}, {},
                [] { return Actions::Words{tr("&Recover…"), tr("Find unsaved work of a program that was closed or killed")}; },
                [this] { askForRecovery(true); });
  m_actions.add("save", "save", {QKeySequence::Save},
                [] { return Actions::Words{tr("&Save"), tr("Save joint and scenario where they were opened from")}; },
                [this] { save(); });
  m_actions.add("saveAs", {}, {QKeySequence::SaveAs},
                [] { return Actions::Words{tr("Save &as…"), tr("Save joint and scenario under a name")}; },
                [this] { saveAs(); });
  m_actions.add("exportJoint", {}, {QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_E)},
                [] { return Actions::Words{tr("Export &joint…"), tr("Write the joint for Gmsh, VTK, SOFA, FEBio, CalculiX or glTF")}; },
                [this] { exportTo(); });
  m_actions.add("picture", "picture", {QKeySequence(Qt::CTRL | Qt::Key_E)},
                [] { return Actions::Words{tr("&Export picture…"), tr("Save what the view shows as a PNG file")}; },
                [this] { exportPicture(); });
  m_actions.add("quit", {}, {QKeySequence::Quit},
                [] { return Actions::Words{tr("&Quit"), tr("Close the program")}; }, [this] { close(); });
}

void MainWindow::makeEditActions() {
  QUndoStack& undo = m_document.undoStack();
  QAction* undoAction = m_actions.add("undo", "undo", {QKeySequence::Undo}, [&undo] {
    const QString what = undo.undoText();
    return Actions::Words{what.isEmpty() ? tr("&Undo") : tr("&Undo: %1").arg(what), tr("Take the last change back")};
  }, [&undo] { undo.undo(); });
  QAction* redoAction = m_actions.add("redo", "redo", {QKeySequence::Redo}, [&undo] {
    const QString what = undo.redoText();
    return Actions::Words{what.isEmpty() ? tr("&Redo") : tr("&Redo: %1").arg(what), tr("Make the change again")};
  }, [&undo] { undo.redo(); });
  const auto refresh = [this, &undo, undoAction, redoAction] {
    undoAction->setEnabled(undo.canUndo());
    redoAction->setEnabled(undo.canRedo());
    m_actions.retranslate();
  };
  connect(&undo, &QUndoStack::indexChanged, this, refresh);
  connect(&undo, &QUndoStack::cleanChanged, this, refresh);
  refresh();
  QAction* remove = m_actions.add("deleteParts", {}, {QKeySequence(QKeySequence::Delete)},
                [] { return Actions::Words{tr("&Delete parts"), tr("Delete the selected parts with everything that refers to them")}; },
                [this] {
                  std::set<std::string> parts = m_selection.ids();
                  std::erase_if(parts, [this](const std::string& id) { return findPart(m_document.joint(), id) < 0; });
                  if (parts.empty()) return;
                  m_selection.clear();
                  m_document.undoStack().beginMacro(tr("Delete %n part(s)", nullptr, static_cast<int>(parts.size())));
                  for (const std::string& part : parts) removePart(m_document, part);
                  m_document.undoStack().endMacro();
                });
  const auto mayDelete = [this, remove] {
    const std::set<std::string> ids = m_selection.ids();
    remove->setEnabled(std::any_of(ids.begin(), ids.end(), [this](const std::string& id) { return findPart(m_document.joint(), id) >= 0; }));
  };
  connect(&m_selection, &Selection::changed, this, mayDelete);
  mayDelete();
  m_actions.add("mirrorJoint", {}, {},
                [] { return Actions::Words{tr("&Mirror the joint"), tr("Make the joint of the other side of the body: meshes, regions, cages, landmarks, tools and cameras")}; },
                [this] {
                  m_selection.clear();
                  if (!mirrorJoint(m_document) || !m_view) return;
                  View view = m_view->view();
                  for (Vec3* each : {&view.eye_W, &view.target_W, &view.up_W}) each->z() = -each->z();
                  m_view->setView(view);
                });
  m_actions.add("selectNone", {}, {QKeySequence(Qt::Key_Escape)},
                [] { return Actions::Words{tr("Select &nothing"), tr("Clear the selection")}; },
                [this] { m_selection.clear(); });
}

void MainWindow::makeViewActions() {
  // Without OpenGL there is no view; the actions stay, greyed, so that menus look the same everywhere.
  const auto onView = [this](void (SceneView::*what)()) {
    return [this, what] {
      if (m_view) (m_view->*what)();
    };
  };
  m_actions.add("frame", "frame", {QKeySequence(Qt::Key_F)},
                [] { return Actions::Words{tr("&Frame selection"), tr("Bring the selected parts into view")}; },
                onView(&SceneView::frameSelection));
  m_actions.add("frameAll", {}, {QKeySequence(Qt::Key_A)},
                [] { return Actions::Words{tr("Frame &all"), tr("Bring everything into view")}; },
                onView(&SceneView::frameAll));
  m_actions.add("home", "home", {QKeySequence(Qt::Key_Home)},
                [] { return Actions::Words{tr("&Home"), tr("Go back to the first view of the scene")}; },
                onView(&SceneView::home));
  struct SideKey {
    Side side;
    Qt::Key key;
    Qt::KeyboardModifiers modifiers;
  };
  static constexpr SideKey kSideKeys[] = {
      {Side::Anterior, Qt::Key_1, Qt::NoModifier}, {Side::Posterior, Qt::Key_1, Qt::ControlModifier},
      {Side::Lateral, Qt::Key_3, Qt::NoModifier},  {Side::Medial, Qt::Key_3, Qt::ControlModifier},
      {Side::Superior, Qt::Key_7, Qt::NoModifier}, {Side::Inferior, Qt::Key_7, Qt::ControlModifier}};
  for (const SideKey& entry : kSideKeys) {
    Keys keys = keypad(entry.key, entry.modifiers);
    // Laptops have no keypad: Alt takes its place.
    keys << QKeySequence(QKeyCombination(entry.modifiers | Qt::AltModifier, entry.key));
    m_actions.add(QStringLiteral("from.") + QLatin1String(sideName(entry.side)), {}, keys, [side = entry.side] {
      QString name;
      switch (side) {
        case Side::Anterior: name = tr("A&nterior (front)"); break;
        case Side::Posterior: name = tr("&Posterior (back)"); break;
        case Side::Lateral: name = tr("&Lateral (outside)"); break;
        case Side::Medial: name = tr("&Medial (inside)"); break;
        case Side::Superior: name = tr("&Superior (above)"); break;
        case Side::Inferior: name = tr("&Inferior (below)"); break;
      }
      return Actions::Words{name, tr("Look at the joint from this side")};
    }, [this, side = entry.side] {
      if (m_view) m_view->lookFrom(side);
    });
  }
  m_actions.addCheckable("dark", "theme", {QKeySequence(Qt::CTRL | Qt::Key_T)},
                         [] { return Actions::Words{tr("&Dark theme"), tr("Switch between dark and light colours")}; },
                         [this](bool dark) { emit themeWanted(dark); })
      ->setChecked(currentTheme().dark);
  if (!m_view) {
    for (const char* id : {"frame", "frameAll", "home"}) m_actions[QLatin1String(id)]->setEnabled(false);
  }
}

/// Off and each quantity, of which one is chosen, and one after another by a key.
void MainWindow::makeColourActions() {
  auto* group = new QActionGroup(this);
  std::vector<std::pair<QAction*, std::optional<Quantity>>> choices;
  const auto add = [&](const QString& id, std::optional<Quantity> quantity) {
    QAction* action = m_actions.addCheckable(QStringLiteral("colour.") + id, {}, {}, [quantity] {
      return Actions::Words{quantity ? quantityLabel(*quantity) : tr("Off"),
                            quantity ? tr("Colour the parts by what they bear") : tr("Show the parts as they look")};
    }, [this, quantity](bool) { m_field.show(quantity); });
    group->addAction(action);
    choices.push_back({action, quantity});
  };
  add(QStringLiteral("off"), std::nullopt);
  for (const Quantity quantity : kQuantities) add(QLatin1String(quantityName(quantity)), quantity);
  m_actions.add(QStringLiteral("colour.next"), {}, {QKeySequence(Qt::Key_V)},
                [] { return Actions::Words{tr("&Next"), tr("Colour by stress, strain, pressure, contact force, and off again")}; },
                [this] { m_field.showNext(); });
  const auto refresh = [this, choices] {
    for (const auto& [action, quantity] : choices) action->setChecked(m_field.quantity() == quantity);
  };
  connect(&m_field, &FieldView::rangeChanged, this, refresh, Qt::QueuedConnection);
  refresh();
}

void MainWindow::makeSimulationActions() {
  QAction* play = m_actions.addCheckable("play", {}, {QKeySequence(Qt::Key_Space)}, [this] {
    const QAction* action = m_actions[QStringLiteral("play")];
    return action->isChecked() ? Actions::Words{tr("&Pause"), tr("Hold the simulation")}
                               : Actions::Words{tr("&Play"), tr("Run the simulation")};
  }, [this](bool on) { on ? m_link.play() : m_link.pause(); });
  play->setIcon(themedIcon("play"));
  connect(play, &QAction::toggled, this, [this, play](bool on) {
    play->setIcon(themedIcon(on ? QStringLiteral("pause") : QStringLiteral("play")));
    m_actions.retranslate();
  });
  m_actions.add("step", "step", {QKeySequence(Qt::Key_Period)},
                [] { return Actions::Words{tr("&Step"), tr("Take a single simulation step")}; },
                [this] { m_link.stepOnce(); });
  m_actions.add("reset", "reset", {QKeySequence(Qt::CTRL | Qt::Key_R)},
                [] { return Actions::Words{tr("&Reset"), tr("Put everything back to the start")}; },
                [this] { m_link.reset(); });
  m_actions.add("saveRun", {}, {},
                [] { return Actions::Words{tr("Save this &run…"), tr("Write what the hands did as a recording that can be replayed")}; },
                [this] { saveRun(); });
  auto* group = new QActionGroup(this);
  static constexpr Profile kProfiles[] = {Profile::Direct, Profile::Paper, Profile::Reference};
  std::vector<QAction*> profiles;
  for (const Profile profile : kProfiles) {
    const QString id = profile == Profile::Direct ? "direct" : profile == Profile::Paper ? "paper" : "reference";
    QAction* action = m_actions.addCheckable(QStringLiteral("profile.") + id, {}, {}, [profile] {
      switch (profile) {
        case Profile::Paper: return Actions::Words{tr("&As published"), tr("The method of the paper, step by step")};
        case Profile::Reference:
          return Actions::Words{tr("&Reference"), tr("Slow and exact; measures the error of the others")};
        case Profile::Direct: break;
      }
      return Actions::Words{tr("&Direct"), tr("Fast and exact; the one to work with")};
    }, [this, profile](bool) { m_document.setProfile(profile); });
    group->addAction(action);
    profiles.push_back(action);
  }
  const auto refresh = [this, profiles] {
    for (std::size_t i = 0; i < profiles.size(); ++i) {
      profiles[i]->setChecked(m_document.scenario().profile == kProfiles[i]);
    }
  };
  connect(&m_document, &Document::changed, this, refresh);
  refresh();
  m_actions.add("about", "about", {QKeySequence::HelpContents},
                [] { return Actions::Words{tr("&About Glenoid Studio"), tr("What this program is, and is not")}; },
                [this] { showAbout(); });
}

void MainWindow::makeMenus() {
  const auto menu = [this] {
    m_menus.push_back(menuBar()->addMenu(QString()));
    return m_menus.back();
  };
  const auto fill = [this](QMenu* target, const QStringList& ids) {
    for (const QString& id : ids) {
      if (id == u"-") {
        target->addSeparator();
      } else {
        target->addAction(m_actions[id]);
      }
    }
  };
  QMenu* file = menu();
  fill(file, {"new"});
  if (m_starter) {
    m_starterMenu = file->addMenu(QString());
    for (const StarterKind& kind : starterKinds()) m_starterMenu->addAction(m_actions[QStringLiteral("starter.") + QLatin1String(kind.name)]);
  }
  fill(file, {"open", "openJoint", "import"});
  m_builtinMenu = file->addMenu(QString());
  for (const char* name : kBuiltins) m_builtinMenu->addAction(m_actions[QLatin1String(name)]);
  fill(file, {"recover", "-", "save", "saveAs", "exportJoint", "picture", "report", "-", "quit"});
  fill(menu(), {"undo", "redo", "-", "deleteParts", "mirrorJoint", "selectNone"});
  QMenu* view = menu();
  view->addMenu(m_workspaces->menu());
  view->addSeparator();
  fill(view, {"frame", "frameAll", "home"});
  m_sideMenu = view->addMenu(themedIcon("view"), QString());
  for (const Side side : kSides) m_sideMenu->addAction(m_actions[QStringLiteral("from.") + QLatin1String(sideName(side))]);
  view->addAction(m_actions[QStringLiteral("scope")]);
  view->addAction(m_actions[QStringLiteral("scope.swap")]);
  m_colourMenu = view->addMenu(QString());
  m_colourMenu->addAction(m_actions[QStringLiteral("colour.off")]);
  for (const Quantity quantity : kQuantities) m_colourMenu->addAction(m_actions[QStringLiteral("colour.") + QLatin1String(quantityName(quantity))]);
  m_colourMenu->addSeparator();
  m_colourMenu->addAction(m_actions[QStringLiteral("colour.next")]);
  view->addSeparator();
  for (QAction* layer : m_layers->layerActions()) view->addAction(layer);
  view->addSeparator();
  for (QDockWidget* dock : m_docks) view->addAction(dock->toggleViewAction());
  for (QDockWidget* dock : m_author->docks()) view->addAction(dock->toggleViewAction());
  for (QDockWidget* dock : m_lab->docks()) view->addAction(dock->toggleViewAction());
  fill(view, {"-", "dark"});
  m_languageMenu = view->addMenu(QString());
  auto* group = new QActionGroup(this);
  for (const QString& code : languages()) {
    QAction* action = m_languageMenu->addAction(languageName(code));  // in its own words, never translated
    action->setObjectName(QStringLiteral("language.") + code);
    action->setCheckable(true);
    action->setChecked(code == currentLanguage());
    group->addAction(action);
    connect(action, &QAction::triggered, this, [this, code] { emit languageWanted(code); });
  }
  menuBar()->addMenu(m_author->menu());
  QMenu* simulate = menu();
  fill(simulate, {"play", "step", "reset", "saveRun", "-"});
  m_solverMenu = simulate->addMenu(QString());
  fill(m_solverMenu, {"profile.direct", "profile.paper", "profile.reference"});
  fill(menu(), {"about"});
  if (!m_view) {
    m_sideMenu->setEnabled(false);
    m_colourMenu->setEnabled(false);
  }
}

void MainWindow::makeToolBars() {
  const auto bar = [this](const char* name) {
    QToolBar* made = addToolBar(QString());
    made->setObjectName(QStringLiteral("bar.") + QLatin1String(name));
    made->setIconSize({20, 20});
    made->setMovable(false);
    m_toolBars.push_back(made);
    return made;
  };
  QToolBar* file = bar("file");
  for (const char* id : {"open", "save", "picture", "-", "undo", "redo", "-", "home", "frame"}) {
    if (*id == '-') {
      file->addSeparator();
    } else {
      file->addAction(m_actions[QLatin1String(id)]);
    }
  }
  auto* sides = new QToolButton;
  sides->setDefaultAction(m_sideMenu->menuAction());
  sides->setPopupMode(QToolButton::InstantPopup);
  file->addWidget(sides);
  QToolBar* run = bar("run");
  for (const char* id : {"play", "step", "reset"}) run->addAction(m_actions[QLatin1String(id)]);
  if (auto* play = qobject_cast<QToolButton*>(run->widgetForAction(m_actions["play"]))) {
    play->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  }
  run->addSeparator();
  for (QAction* layer : m_layers->layerActions()) run->addAction(layer);
  // Qt gives buttons of a toolbar no accessible name; they follow their actions' texts.
  std::vector<QToolBar*> all = m_toolBars;
  all.push_back(m_author->toolBar());
  for (QToolBar* target : all) {
    for (QAction* action : target->actions()) {
      QWidget* button = target->widgetForAction(action);
      if (!button || action->isSeparator()) continue;
      const auto name = [action, button] { button->setAccessibleName(action->text().remove(QLatin1Char('&'))); };
      connect(action, &QAction::changed, button, name);
      name();
    }
  }
}

// ---- Dialogs

void MainWindow::askForScene() {
  if (!mayDiscard()) return;
  const QString path = QFileDialog::getOpenFileName(this, tr("Open a scenario"), {},
                                                    tr("Scenarios, joints and recorded runs (*.scenario.json *.jointz joint.json *.recording);;All files (*)"));
  if (!path.isEmpty()) openScene(path);
}

void MainWindow::askForJointFolder() {
  if (!mayDiscard()) return;
  const QString path = QFileDialog::getExistingDirectory(this, tr("Open a joint folder"));
  if (!path.isEmpty()) openScene(path);
}

/// A scene that ships, or was never saved, has no place of its own.
void MainWindow::save() {
  const QString path = m_document.path();
  if (path.endsWith(u".scenario.json") && QFileInfo(path).isFile()) saveTo(path);
  else saveAs();
}

void MainWindow::saveAs() {
  QString path = QFileDialog::getSaveFileName(
      this, tr("Save the scene"), m_document.path().endsWith(u".scenario.json") ? m_document.path() : QString::fromStdString(m_document.scenario().id) + QStringLiteral(".scenario.json"),
      tr("Scenarios (*.scenario.json)"));
  if (path.isEmpty()) return;
  if (!path.endsWith(u".scenario.json")) path += QStringLiteral(".scenario.json");
  saveTo(path);
}

void MainWindow::saveTo(const QString& path) {
  const auto saved = m_saver(m_document.scene(), path.toStdString());
  if (saved.ok()) {
    m_document.saved(path);
    showProblem({});
    statusBar()->showMessage(tr("Saved to %1").arg(QDir::toNativeSeparators(path)), 5000);
  } else {
    showProblem(sentenceOf(saved.error()));
  }
}

void MainWindow::exportPicture() {
  if (!m_view) return showProblem(sentenceOf({Fault::NoGraphics, {}, {}, {}}));
  QString path = QFileDialog::getSaveFileName(this, tr("Export a picture"), QStringLiteral("glenoid.png"),
                                              tr("Pictures (*.png)"));
  if (path.isEmpty()) return;
  if (!path.endsWith(u".png", Qt::CaseInsensitive)) path += QStringLiteral(".png");
  const qreal ratio = m_view->devicePixelRatioF();
  const QImage image = m_view->picture(static_cast<int>(m_view->width() * ratio),
                                       static_cast<int>(m_view->height() * ratio));
  if (image.isNull() || !image.save(path)) {
    showProblem(sentenceOf({Fault::FileUnwritable, {path.toStdString(), {}, {}, {}}, {}, {}}));
  }
}

void MainWindow::showAbout() {
  QMessageBox box(this);
  box.setObjectName(QStringLiteral("about"));
  box.setWindowTitle(tr("About Glenoid Studio"));
  box.setIconPixmap(QIcon(QStringLiteral(":/icons/glenoid.svg")).pixmap(64, 64));
  box.setText(tr("<h3>Glenoid Studio</h3><p>Author interactive simulations of human joints, and train on them.</p>"));
  box.setInformativeText(
      tr("<p>This is a training aid, not a medical device. Do not use it for diagnosis, for treatment or to plan "
         "an operation.</p><p>The method follows Otaduy, Garre, Gascón, Miguel, Pérez and Zurdo, “Modeling and "
         "Simulation of a Human Shoulder for Interactive Medical Applications”, CEIG 2010.</p><p>Free software under "
         "the GNU General Public License, version 3 or later.</p>"));
  box.exec();
}

}  // namespace glenoid
