// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/ui/LayersPanel.h"

#include <QAction>
#include <QEvent>
#include <QGridLayout>
#include <QToolButton>

#include "editor/ui/Theme.h"

namespace glenoid {
namespace {

const char* layerWord(DisplayState::Layer layer) {
  switch (layer) {
    case DisplayState::Layer::Visual: return "visual";
    case DisplayState::Layer::Collision: return "collision";
    case DisplayState::Layer::Dynamics: return "dynamics";
    case DisplayState::Layer::Couplings: return "couplings";
    case DisplayState::Layer::Islands: return "islands";
    case DisplayState::Layer::Contacts: return "contacts";
    case DisplayState::Layer::Regions: return "regions";
    case DisplayState::Layer::Labels: return "labels";
    case DisplayState::Layer::Marker: return "marker";
  }
  return "";
}

}  // namespace

LayersPanel::LayersPanel(DisplayState& display, QWidget* parent) : QWidget(parent), m_display(display) {
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(8, 8, 8, 8);
  grid->setSpacing(4);
  int index = 0;
  for (const DisplayState::Layer layer : DisplayState::kLayers) {
    const QString word = QLatin1String(layerWord(layer));
    auto* action = new QAction(themedIcon(QStringLiteral("layer-") + word), {}, this);
    action->setObjectName(QStringLiteral("layer.") + word);
    action->setCheckable(true);
    action->setChecked(display.isShown(layer));
    connect(action, &QAction::toggled, this, [this, layer](bool on) { m_display.show(layer, on); });
    connect(&display, &DisplayState::changed, action,
            [this, action, layer] { action->setChecked(m_display.isShown(layer)); });
    auto* button = new QToolButton;
    button->setDefaultAction(action);
    button->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    button->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    grid->addWidget(button, index / 2, index % 2);
    m_actions.push_back(action);
    m_buttons.push_back(button);
    ++index;
  }
  grid->setColumnStretch(0, 1);
  grid->setColumnStretch(1, 1);
  grid->setRowStretch((index + 1) / 2, 1);
  retranslate();
}

void LayersPanel::retranslate() {
  const QStringList names = {tr("Visual"),   tr("Collision"), tr("Dynamics"), tr("Couplings"), tr("Islands"),
                             tr("Contacts"), tr("Regions"),   tr("Labels"),   tr("Orientation")};
  const QStringList tips = {tr("Show the smooth visual surfaces"),
                            tr("Show the surfaces that collide, with their edges"),
                            tr("Show the tetrahedra that deform"),
                            tr("Show the springs that couple the parts"),
                            tr("Colour the parts by what couplings join; fixed parts keep their colour"),
                            tr("Show where parts touch, and how hard"),
                            tr("Show the named regions of the parts"),
                            tr("Show the names of what is seen"),
                            tr("Show which way is front, up and outward")};
  for (int i = 0; i < static_cast<int>(m_actions.size()); ++i) {
    m_actions[i]->setText(names.value(i));
    m_actions[i]->setToolTip(tips.value(i));
    m_actions[i]->setStatusTip(tips.value(i));
    m_buttons[i]->setAccessibleName(names.value(i));
  }
}

void LayersPanel::changeEvent(QEvent* event) {
  if (event->type() == QEvent::LanguageChange) retranslate();
  QWidget::changeEvent(event);
}

}  // namespace glenoid
