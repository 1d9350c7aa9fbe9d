// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/AuthorDocks.h"

#include <QActionGroup>
#include <QDockWidget>
#include <QMainWindow>
#include <QMenu>
#include <QToolBar>

#include "editor/core/JobSystem.h"
#include "editor/ui/BodyPanel.h"
#include "editor/ui/CagePanel.h"
#include "editor/ui/CouplingPanel.h"
#include "editor/ui/SceneView.h"

namespace glenoid {
namespace {

struct ModeKey {
  PickMode mode;
  const char* word;
  Qt::Key key;
};
constexpr ModeKey kModes[] = {{PickMode::Click, "click", Qt::Key_C},
                              {PickMode::Box, "box", Qt::Key_B},
                              {PickMode::Lasso, "lasso", Qt::Key_L},
                              {PickMode::Brush, "brush", Qt::Key_P}};

}  // namespace

AuthorDocks::AuthorDocks(QMainWindow& window, Actions& actions, Document& document, JobSystem& jobs,
                         DisplayState& display, Selection& selection, SceneView* view)
    : QObject(&window), m_window(window), m_view(view), m_authoring(document, display) {
  if (view) view->setAuthoring(&m_authoring);
  addDock("couplings", new CouplingPanel(document, selection, m_authoring));
  auto* cages = new CagePanel(document, selection, m_authoring, jobs);
  addDock("cages", cages);
  connect(cages, &CagePanel::partsWanted, this,
          [&selection, view](const std::set<std::string>& ids, const std::string& current) {
            selection.assign(ids, current);
            if (view) view->frameSelection();
          });
  auto* bodies = new BodyPanel(document, m_authoring);
  addDock("bodies", bodies, Qt::BottomDockWidgetArea);
  m_docks.back()->hide();
  if (view) {
    bodies->setViewSource([view] { return view->view(); });
    connect(view, &SceneView::drawn, bodies, &BodyPanel::viewMoved);
  }
  makeActions(actions);
}

AuthorDocks::~AuthorDocks() {
  if (m_view) m_view->setAuthoring(nullptr);
}

void AuthorDocks::addDock(const char* name, QWidget* content, Qt::DockWidgetArea area) {
  auto* made = new QDockWidget(&m_window);
  made->setObjectName(QStringLiteral("dock.") + QLatin1String(name));
  made->setWidget(content);
  made->setFeatures(QDockWidget::DockWidgetMovable | QDockWidget::DockWidgetClosable |
                    QDockWidget::DockWidgetFloatable);
  m_window.addDockWidget(area, made);
  if (area != Qt::RightDockWidgetArea) {
    // Stands alone below the view.
  } else if (auto* properties = m_window.findChild<QDockWidget*>(QStringLiteral("dock.properties"))) {
    m_window.tabifyDockWidget(properties, made);
    properties->raise();
  }
  m_docks.push_back(made);
}

void AuthorDocks::makeActions(Actions& actions) {
  m_menu = new QMenu(&m_window);
  m_toolBar = new QToolBar(&m_window);
  m_window.addToolBar(Qt::LeftToolBarArea, m_toolBar);
  m_toolBar->setObjectName(QStringLiteral("bar.author"));
  m_toolBar->setIconSize({20, 20});
  m_toolBar->setMovable(false);
  const auto place = [this](QAction* action) {
    m_menu->addAction(action);
    m_toolBar->addAction(action);
    return action;
  };
  QAction* select = place(actions.addCheckable(
      "author.select", "pick", {QKeySequence(Qt::Key_E)},
      [] {
        return Actions::Words{
            tr("&Pick on a part"),
            tr("Pick triangles or nodes of a part with the mouse; Shift adds, Ctrl takes away, Alt goes through")};
      },
      [this](bool on) { m_authoring.setTool(on ? Authoring::Tool::Select : Authoring::Tool::None); }));
  QAction* cage = place(actions.addCheckable(
      "author.cage", "cage", {QKeySequence(Qt::Key_G)},
      [] {
        return Actions::Words{tr("&Move a cage"),
                              tr("Pick and drag the handles of the cage around the chosen part")};
      },
      [this](bool on) { m_authoring.setTool(on ? Authoring::Tool::Cage : Authoring::Tool::None); }));
  QDockWidget* bodies = m_docks.back();
  QAction* body = place(actions.addCheckable(
      "author.body", "body", {QKeySequence(Qt::Key_M)},
      [] {
        return Actions::Words{tr("Make a bod&y"),
                              tr("Show how the chosen part collides and deforms, and change it")};
      },
      [bodies](bool on) { bodies->setVisible(on); }));
  connect(bodies, &QDockWidget::visibilityChanged, body,
          [body, bodies] { body->setChecked(!bodies->isHidden()); });
  m_menu->addSeparator();
  m_toolBar->addSeparator();
  const auto pick = [this](Authoring::Picking what) {
    m_authoring.setPicking(what);
    if (m_authoring.tool() != Authoring::Tool::Select) m_authoring.setTool(Authoring::Tool::Select);
  };
  QAction* triangles = place(actions.addCheckable(
      "author.triangles", "pick-triangles", {QKeySequence(Qt::Key_T)},
      [] {
        return Actions::Words{tr("&Triangles"), tr("Pick triangles of a surface, for regions")};
      },
      [pick](bool) { pick(Authoring::Picking::Triangles); }));
  QAction* nodes = place(actions.addCheckable(
      "author.nodes", "pick-nodes", {QKeySequence(Qt::Key_N)},
      [] {
        return Actions::Words{tr("N&odes"), tr("Pick nodes of a soft part's cells, which springs will hold")};
      },
      [pick](bool) { pick(Authoring::Picking::Nodes); }));
  auto* what = new QActionGroup(this);
  for (QAction* each : {triangles, nodes}) what->addAction(each);
  m_menu->addSeparator();
  m_toolBar->addSeparator();
  std::vector<QAction*> modes;
  for (const ModeKey& entry : kModes) {
    QAction* action = place(actions.addCheckable(
        QStringLiteral("author.") + QLatin1String(entry.word),
        QStringLiteral("pick-") + QLatin1String(entry.word), {QKeySequence(entry.key)},
        [mode = entry.mode] {
          switch (mode) {
            case PickMode::Click:
              return Actions::Words{tr("By &click"), tr("Pick what is under the cursor")};
            case PickMode::Box:
              return Actions::Words{tr("By &box"), tr("Pick what lies in a rectangle")};
            case PickMode::Lasso:
              return Actions::Words{tr("By &lasso"), tr("Pick what a drawn line goes around")};
            case PickMode::Brush:
              break;
          }
          return Actions::Words{tr("By b&rush"),
                                tr("Paint over what shall be picked; [ and ] change the brush")};
        },
        [this, mode = entry.mode](bool) {
          m_authoring.setMode(mode);
          if (m_authoring.tool() == Authoring::Tool::None) m_authoring.setTool(Authoring::Tool::Select);
        }));
    modes.push_back(action);
  }
  auto* group = new QActionGroup(this);
  for (QAction* mode : modes) group->addAction(mode);
  m_menu->addSeparator();
  m_toolBar->addSeparator();
  const auto step = [&](const char* id, const char* icon, QKeySequence key, Actions::Source words, auto run) {
    return place(actions.add(QLatin1String(id), QLatin1String(icon), {key}, std::move(words), run));
  };
  std::vector<QAction*> onSelection = {
      step(
          "author.grow", "pick-grow", QKeySequence(Qt::CTRL | Qt::Key_Up),
          [] {
            return Actions::Words{tr("&Grow"), tr("Select one ring more")};
          },
          [this] { m_authoring.grow(); }),
      step(
          "author.shrink", "pick-shrink", QKeySequence(Qt::CTRL | Qt::Key_Down),
          [] {
            return Actions::Words{tr("&Shrink"), tr("Select one ring less")};
          },
          [this] { m_authoring.shrink(); }),
      step(
          "author.connected", "pick-connected", QKeySequence(Qt::CTRL | Qt::Key_L),
          [] {
            return Actions::Words{tr("C&onnected"), tr("Select the whole piece that is connected")};
          },
          [this] { m_authoring.selectConnected(); }),
      step(
          "author.clear", "pick-none", QKeySequence(Qt::CTRL | Qt::SHIFT | Qt::Key_A),
          [] {
            return Actions::Words{tr("&None"), tr("Select nothing")};
          },
          [this] { m_authoring.clear(); })};
  QAction* invert = step(
      "author.invert", "pick-invert", QKeySequence(Qt::CTRL | Qt::Key_I),
      [] {
        return Actions::Words{tr("&Invert"), tr("Select all others")};
      },
      [this] { m_authoring.invert(); });
  m_menu->addSeparator();
  m_menu->addAction(actions.add(
      "author.smaller", {}, {QKeySequence(Qt::Key_BracketLeft)},
      [] {
        return Actions::Words{tr("S&maller brush"), tr("Make the brush smaller")};
      },
      [this] { m_authoring.setRadius(m_authoring.radius() / 1.25); }));
  m_menu->addAction(actions.add(
      "author.larger", {}, {QKeySequence(Qt::Key_BracketRight)},
      [] {
        return Actions::Words{tr("L&arger brush"), tr("Make the brush larger")};
      },
      [this] { m_authoring.setRadius(m_authoring.radius() * 1.25); }));
  const auto refresh = [=, this] {
    select->setChecked(m_authoring.tool() == Authoring::Tool::Select);
    cage->setChecked(m_authoring.tool() == Authoring::Tool::Cage);
    for (std::size_t i = 0; i < modes.size(); ++i) modes[i]->setChecked(kModes[i].mode == m_authoring.mode());
    const bool byNodes = m_authoring.picking() == Authoring::Picking::Nodes;
    triangles->setChecked(!byNodes);
    nodes->setChecked(byNodes);
    for (QAction* action : onSelection) action->setEnabled(m_authoring.anySelected());
    invert->setEnabled(byNodes ? m_authoring.cells() != nullptr : m_authoring.mesh() != nullptr);
  };
  connect(&m_authoring, &Authoring::toolChanged, this, refresh);
  connect(&m_authoring, &Authoring::modeChanged, this, refresh);
  connect(&m_authoring, &Authoring::selectionChanged, this, refresh);
  refresh();
}

void AuthorDocks::retranslate() {
  m_menu->setTitle(tr("&Author"));
  m_toolBar->setWindowTitle(tr("Author's tools"));
  const QStringList docks = {tr("Couplings"), tr("Start"), tr("Body")};
  for (std::size_t i = 0; i < m_docks.size(); ++i)
    m_docks[i]->setWindowTitle(docks.value(static_cast<int>(i)));
}

}  // namespace glenoid
