// SPDX-License-Identifier: GPL-3.0-or-later
#include "editor/core/DisplayState.h"

#include <algorithm>
#include <cmath>

#include "editor/core/AnatomyNames.h"

namespace glenoid {

bool Layers::*DisplayState::member(Layer layer) {
  switch (layer) {
    case Layer::Visual: return &Layers::visual;
    case Layer::Collision: return &Layers::collision;
    case Layer::Dynamics: return &Layers::dynamics;
    case Layer::Couplings: return &Layers::couplings;
    case Layer::Islands: return &Layers::islands;
    case Layer::Contacts: return &Layers::contacts;
    case Layer::Regions: return &Layers::regions;
    case Layer::Labels: return &Layers::labels;
    case Layer::Marker: return &Layers::marker;
  }
  return &Layers::visual;
}

void DisplayState::show(Layer layer, bool on) {
  if (isShown(layer) == on) return;
  m_layers.*member(layer) = on;
  emit changed();
}

ObjectLook DisplayState::lookOf(const std::string& id) const {
  const auto found = m_looks.find(id);
  return found == m_looks.end() ? ObjectLook{} : found->second;
}

void DisplayState::setVisible(const std::string& id, bool visible) {
  if (isVisible(id) == visible) return;
  m_looks[id].visible = visible;
  emit changed();
}

void DisplayState::setOpacity(const std::string& id, double opacity) {
  const float clamped = static_cast<float>(std::clamp(opacity, 0.0, 1.0));
  if (lookOf(id).opacity == clamped) return;
  m_looks[id].opacity = clamped;
  emit changed();
}

void DisplayState::solo(const std::set<std::string>& ids) {
  if (m_soloed == ids) return;
  m_soloed = ids;
  emit changed();
}

void DisplayState::showAll() {
  m_looks.clear();
  m_soloed.clear();
  emit changed();
}

std::array<float, 3> DisplayState::islandColor(int island) {
  // Hues a golden section apart never come near to each other soon; two lightnesses by turns.
  const double hue = std::fmod(0.56 + 0.618033988749895 * island, 1.0);
  const double value = island % 2 ? 0.70 : 0.85, saturation = 0.55;
  std::array<float, 3> color;
  for (int i = 0; i < 3; ++i) {
    const double k = std::fmod(hue * 6 + std::array{5.0, 3.0, 1.0}[i], 6.0);
    color[i] = static_cast<float>(value * (1 - saturation * std::clamp(std::min(k, 4 - k), 0.0, 1.0)));
  }
  return color;
}

Layers DisplayState::layersFor(const Model& model, const Selection& selection) const {
  Layers layers = m_layers;
  for (const SceneObject& object : model.objects) {
    ObjectLook look = lookOf(object.id);
    if (!m_soloed.empty()) look.visible = m_soloed.count(object.id) > 0;
    look.selected = selection.contains(object.id);
    look.hovered = selection.hovered() == object.id;
    if (const std::size_t index = layers.objects.size();
        layers.islands && !object.tool && index < model.couplingIslandOfObject.size() &&
        model.couplingIslandOfObject[index] >= 0)
      look.color = islandColor(model.couplingIslandOfObject[index]);
    layers.objects.push_back(look);
  }
  if (layers.labels)
    for (const char* name : anatomyNames()) layers.names[name] = anatomyName(name).toStdString();
  return layers;
}

}  // namespace glenoid
