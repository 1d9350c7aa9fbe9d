// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/Picture.h"

#include <algorithm>
#include <charconv>

#include "app/commands/Console.h"
#include "app/commands/Sheet.h"
#include "editor/render/SceneRenderer.h"
#include "simcore/body/SurfaceBinding.h"

namespace glenoid {
namespace {

Error unknown(const std::string& id, const std::string& kind) { return {Fault::UnknownId, {}, {id, kind}, "picture"}; }

/// Box around one object's visual surface, W; around its cells too where they are shown.
Box3 boxOf(const SceneObject& object, const VecX& q, bool cells) {
  std::vector<Vec3> positions(object.visual.vertices.size());
  surfacePositions(object.visual, object.layout, q, positions);
  Box3 box;
  for (const Vec3& p : positions) box.extend(p);
  if (cells && !object.layout.rigid)
    for (int node = 0; node < object.layout.nodeCount; ++node) box.extend(Vec3(q.segment<3>(object.layout.qOffset + 3 * node)));
  return box;
}

Result<View> chooseView(const Model& model, const std::string& name, const Box3& box, double aspect, bool framePart) {
  const std::vector<Camera>& cameras = model.scenario.cameras;
  for (const Camera& camera : cameras)
    if (camera.id == name) return framePart ? framed(viewOf(camera), box, aspect) : viewOf(camera);
  if (const auto side = sideNamed(name)) return viewFrom(*side, box, aspect);
  if (!name.empty()) return unknown(name, "camera");
  if (framePart || cameras.empty()) return viewFrom(Side::Anterior, box, aspect);
  return viewOf(cameras.front());
}

}  // namespace

Result<Done> readSize(const std::string& words, PictureWishes& wishes) {
  const char *begin = words.data(), *end = begin + words.size();
  const auto width = std::from_chars(begin, end, wishes.width);
  const bool cross = width.ec == std::errc() && width.ptr != end && *width.ptr == 'x';
  const auto height = cross ? std::from_chars(width.ptr + 1, end, wishes.height) : width;
  if (!cross || height.ec != std::errc() || height.ptr != end) return usageError("--size wants WIDTHxHEIGHT, such as 1280x960");
  for (const int side : {wishes.width, wishes.height})
    if (side < 1 || side > kImageSideMax)
      return Error{Fault::OutOfRange, {}, {std::to_string(side), "1", std::to_string(kImageSideMax)}, "--size"};
  return Done{};
}

Result<Done> drawPicture(const Model& model, const State& state, std::span<const ContactView> contacts,
                         const PictureWishes& wishes, std::span<const DentView> dents) {
  const Result<Sheet> sheet = sheetNamed(wishes.sheet);
  if (!sheet) return sheet.error();
  Layers layers;
  if (!wishes.layers.empty()) {
    Result<Layers> chosen = layersFromWords(wishes.layers);
    if (!chosen) return chosen.error();
    layers = std::move(*chosen);
  }
  layers.dents.assign(dents.begin(), dents.end());
  Box3 box = sceneBounds(model, state.q);
  int only = -1;
  if (!wishes.part.empty()) {
    for (std::size_t i = 0; i < model.objects.size(); ++i) {
      const SceneObject& object = model.objects[i];
      if (object.id == wishes.part || (object.number > 0 && std::to_string(object.number) == wishes.part))
        only = static_cast<int>(i);
    }
    if (only < 0) return unknown(wishes.part, "part");
    layers.objects.assign(model.objects.size(), ObjectLook{});
    // A cage is seen among what it keeps its part from.
    for (std::size_t i = 0; i < layers.objects.size() && *sheet != Sheet::Cage; ++i) layers.objects[i].visible = static_cast<int>(i) == only;
    box = boxOf(model.objects[only], state.q, layers.dynamics || *sheet == Sheet::Meshes);
  }
  const std::vector<Panel> panels = panelsOf(*sheet, model, layers, only < 0 ? std::string() : model.objects[only].id);
  if (panels.empty()) return usageError("there is nothing to show on this sheet");
  const int width = std::max(wishes.width / static_cast<int>(panels.size()), 1);
  const double aspect = static_cast<double>(width) / wishes.height;
  const Result<View> view = chooseView(model, wishes.camera, box, aspect, !wishes.part.empty());
  if (!view) return view.error();
  std::vector<Image> images;
  for (const Panel& panel : panels) {
    State shown = state;
    if (panel.q.size() > 0) shown.q = panel.q;
    Result<Image> image = renderPicture(model, shown, *view, panel.layers, width, wishes.height, {}, contacts);
    if (!image) return image.error();
    images.push_back(std::move(*image));
  }
  return writePng(besideEachOther(images), wishes.out);
}

}  // namespace glenoid
