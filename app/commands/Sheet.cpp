// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/Sheet.h"

#include <algorithm>

#include "app/commands/Console.h"
#include "simcore/author/Overlaps.h"
#include "simcore/spatial/Intersect.h"

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

/// The start with every caged part back at rest.
VecX atRest(const Model& model) {
  VecX q = model.start.q;
  for (const SceneObject& object : model.objects)
    if (!object.tool && findCage(model.joint, object.id))
      for (int node = 0; node < object.layout.nodeCount; ++node)
        q.segment<3>(object.layout.qOffset + 3 * node) = object.volume->nodes[node];
  return q;
}

/// Visual triangles of caged parts, and what they cut, where parts that may collide cut each other at rest.
std::vector<TriangleMark> cutsAtRest(const Model& model) {
  std::vector<TriangleMark> marks;
  for (const auto& [a, b] : pairsThatMayCollide(model.joint)) {
    const Part &first = model.joint.parts[a], &second = model.joint.parts[b];
    if (!findCage(model.joint, first.id) && !findCage(model.joint, second.id)) continue;
    TriangleMark ofFirst{a, SurfaceKind::Visual, {}}, ofSecond{b, SurfaceKind::Visual, {}};  // objects begin with the parts
    for (const auto& [i, j] : intersectingTriangles(*first.visual, *second.visual)) {
      ofFirst.triangles.push_back(i);
      ofSecond.triangles.push_back(j);
    }
    for (TriangleMark* mark : {&ofFirst, &ofSecond}) {
      std::sort(mark->triangles.begin(), mark->triangles.end());
      mark->triangles.erase(std::unique(mark->triangles.begin(), mark->triangles.end()), mark->triangles.end());
      if (!mark->triangles.empty()) marks.push_back(std::move(*mark));
    }
  }
  return marks;
}

/// Edges at rest, handles and edges as moved.
Strokes strokesOf(const Cage& cage) {
  constexpr std::array<float, 4> kRest{0.45f, 0.48f, 0.52f, 0.35f}, kMoved{0.05f, 0.5f, 0.55f, 1};
  Strokes strokes;
  strokes.hiddenStrength = 0.15f;
  strokes.dotPx = 5;
  const auto line = [&](const std::vector<Vec3>& at, int from, int to, const std::array<float, 4>& color) {
    for (const int end : {from, to}) strokes.lines.push_back({at[end].cast<float>(), color});
  };
  for (const auto& t : cage.triangles)
    for (int k = 0; k < 3; ++k) {
      if (t[k] > t[(k + 1) % 3]) continue;
      line(cage.rest_W, t[k], t[(k + 1) % 3], kRest);
      line(cage.moved_W, t[k], t[(k + 1) % 3], kMoved);
    }
  for (const Vec3& handle : cage.moved_W) strokes.dots.push_back({handle.cast<float>(), kMoved});
  return strokes;
}

std::vector<Panel> cagePanels(const Model& model, const Layers& layers, const std::string& part) {
  if (model.joint.cages.empty()) return {};
  const VecX rest = atRest(model);
  std::vector<Panel> panels(3, Panel{layers, {}});
  panels[0].q = rest;
  panels[0].layers.marks = cutsAtRest(model);
  panels[1].layers.marker = panels[2].layers.marker = false;
  for (const Cage& cage : model.joint.cages)
    if (part.empty() || part == cage.part) panels[1].layers.strokes.push_back(strokesOf(cage));
  if (panels[1].layers.strokes.empty()) return {};
  return panels;
}

}  // namespace

Result<Sheet> sheetNamed(const std::string& word) {
  if (word.empty()) return Sheet::None;
  if (word == "anatomy") return Sheet::Anatomy;
  if (word == "meshes") return Sheet::Meshes;
  if (word == "cage") return Sheet::Cage;
  return usageError("--sheet wants anatomy, meshes or cage, not “" + word + "”");
}

std::vector<Panel> panelsOf(Sheet sheet, const Model& model, const Layers& layers, const std::string& part) {
  std::vector<Panel> panels;
  const auto take = [&](std::vector<Layers> list) {
    for (Layers& each : list) panels.push_back({std::move(each), {}});
  };
  switch (sheet) {
    case Sheet::Anatomy: take(anatomyPanels(model, layers)); break;
    case Sheet::Meshes: take(meshPanels(layers)); break;
    case Sheet::Cage: return cagePanels(model, layers, part);
    case Sheet::None: panels.push_back({layers, {}}); break;
  }
  return panels;
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
