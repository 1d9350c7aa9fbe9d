// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/Sheet.h"

#include <algorithm>

#include "app/commands/Console.h"

namespace glenoid {
namespace {

/// 0 for bone, ascending outwards; −1 for a tool.
int depthOf(const Model& model, const SceneObject& object) {
  if (object.tool) return -1;
  const Part& part = model.joint.parts[findPart(model.joint, object.id)];
  switch (appearanceOf(model.joint, part)) {
    case Appearance::Bone: return 0;
    case Appearance::Cartilage:
    case Appearance::Ligament:
    case Appearance::Tendon: return 1;
    case Appearance::Muscle: return 2;
    case Appearance::Skin: return 3;
    case Appearance::Plain: break;
  }
  return part.kind == PartKind::Rigid ? 0 : 2;
}

std::vector<Layers> anatomyPanels(const Model& model, const Layers& layers) {
  std::vector<Layers> panels;
  for (int depth = 0; depth < 4; ++depth) {
    Layers panel = layers;
    panel.objects.resize(model.objects.size());
    bool adds = false;
    for (std::size_t i = 0; i < model.objects.size(); ++i) {
      const int own = depthOf(model, model.objects[i]);
      adds = adds || (own == depth && panel.objects[i].visible);
      panel.objects[i].visible = panel.objects[i].visible && own >= 0 && own <= depth;
    }
    panel.marker = layers.marker && panels.empty();
    if (adds) panels.push_back(std::move(panel));
  }
  return panels;
}

std::vector<Layers> meshPanels(const Layers& layers) {
  std::vector<Layers> panels(3, layers);
  for (std::size_t i = 0; i < panels.size(); ++i) {
    panels[i].visual = i == 0;
    panels[i].collision = i == 1;
    panels[i].dynamics = i == 2;
    panels[i].marker = layers.marker && i == 0;
  }
  return panels;
}

}  // namespace

Result<Sheet> sheetNamed(const std::string& word) {
  if (word.empty()) return Sheet::None;
  if (word == "anatomy") return Sheet::Anatomy;
  if (word == "meshes") return Sheet::Meshes;
  return usageError("--sheet wants anatomy or meshes, not “" + word + "”");
}

std::vector<Layers> panelsOf(Sheet sheet, const Model& model, const Layers& layers) {
  switch (sheet) {
    case Sheet::Anatomy: return anatomyPanels(model, layers);
    case Sheet::Meshes: return meshPanels(layers);
    case Sheet::None: break;
  }
  return {layers};
}

Image besideEachOther(const std::vector<Image>& images) {
  Image sheet;
  for (const Image& image : images) {
    sheet.width += image.width;
    sheet.height = image.height;
  }
  sheet.rgba.resize(4 * static_cast<std::size_t>(sheet.width) * sheet.height);
  std::size_t left = 0;
  for (const Image& image : images) {
    const std::size_t row = 4 * static_cast<std::size_t>(image.width);
    for (int y = 0; y < image.height; ++y)
      std::copy_n(image.rgba.begin() + static_cast<std::ptrdiff_t>(y * row), row,
                  sheet.rgba.begin() + static_cast<std::ptrdiff_t>(4 * (static_cast<std::size_t>(y) * sheet.width + left)));
    left += image.width;
  }
  return sheet;
}

}  // namespace glenoid
