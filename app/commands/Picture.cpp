// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/Picture.h"

#include <CLI/CLI.hpp>
#include <algorithm>
#include <charconv>
#include <cmath>
#include <optional>

#include "app/commands/Console.h"
#include "app/commands/Sheet.h"
#include "editor/core/FieldText.h"
#include "editor/render/SceneRenderer.h"
#include "editor/render/ScopeView.h"
#include "simcore/body/SurfaceBinding.h"
#include "simcore/reading/SurfaceField.h"

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

/// "scope", "scope:TOOL": the object that is looked through; −1: another camera.
Result<int> scopeNamed(const Model& model, const std::string& name) {
  constexpr std::string_view kWord = "scope", kOwn = "scope:";
  const bool own = name.starts_with(kOwn);
  const std::vector<Camera>& cameras = model.scenario.cameras;
  if ((name != kWord && !own) || std::any_of(cameras.begin(), cameras.end(), [&](const Camera& camera) { return camera.id == name; })) return -1;
  const auto found = findScope(model, own ? std::string_view(name).substr(kOwn.size()) : std::string_view());
  if (found) return *found;
  if (own) return unknown(name.substr(kOwn.size()), "arthroscope");
  return usageError("--camera scope wants an arthroscope among the scenario's tools, and there is none");
}

Result<View> chooseView(const Model& model, const std::string& name, const Box3& box, double aspect, bool framePart) {
  const std::vector<Camera>& cameras = model.scenario.cameras;
  for (const Camera& camera : cameras)
    if (camera.id == name) return framePart ? framed(viewOf(camera), box, aspect) : viewOf(camera);
  if (const auto side = sideNamed(name)) return viewFrom(*side, box, aspect, 0.5, model.joint.side);
  if (!name.empty()) return unknown(name, "camera");
  if (framePart || cameras.empty()) return viewFrom(Side::Anterior, box, aspect);
  return viewOf(cameras.front());
}

/// "0.5MPa" in SI; nothing where it is no amount.
std::optional<double> amountIn(std::string_view words, bool strain) {
  double value = 0;
  const auto [end, fault] = std::from_chars(words.data(), words.data() + words.size(), value);
  if (fault != std::errc() || !std::isfinite(value)) return std::nullopt;
  const std::string_view unit = words.substr(static_cast<std::size_t>(end - words.data()));
  if (unit.empty()) return value;
  if (strain) return unit == "%" ? std::optional(0.01 * value) : std::nullopt;
  return unit == "Pa" ? std::optional(value) : unit == "kPa" ? std::optional(1e3 * value) : unit == "MPa" ? std::optional(1e6 * value) : std::nullopt;
}

/// Nothing where no range was wished.
Result<std::optional<FieldRange>> rangeNamed(Quantity quantity, const std::string& words) {
  if (words.empty()) return std::optional<FieldRange>();
  const bool strain = quantity == Quantity::Strain;
  const std::size_t colon = words.find(':');
  const auto low = amountIn(std::string_view(words).substr(0, colon), strain);
  const auto high = colon == std::string::npos ? std::nullopt : amountIn(std::string_view(words).substr(colon + 1), strain);
  if (!low || !high || !(*high > *low))
    return usageError("--colour-range wants LOW:HIGH, LOW below HIGH, such as " + std::string(strain ? "0:20% or 0:0.2" : "0:50kPa or 0:50000") + ", not “" +
                      words + "”");
  return std::optional(FieldRange{*low, *high});
}

/// What the surfaces of a state show, those of `shown` alone deciding on a range of their own.
Result<std::optional<FieldLook>> coloursOf(const Model& model, const State& state, std::span<const ContactView> contacts, const PictureWishes& wishes,
                                           const Layers& layers) {
  if (wishes.colour.empty()) return std::optional<FieldLook>();
  const Quantity quantity = *quantityNamed(wishes.colour);
  Result<std::optional<FieldRange>> range = rangeNamed(quantity, wishes.colourRange);
  if (!range) return range.error();
  // The caller's model outlives the field.
  const SurfaceField field(std::shared_ptr<const Model>(std::shared_ptr<const Model>(), &model));
  if (quantity != Quantity::Contact && !field.hasTissue()) return usageError("--colour " + wishes.colour + " wants a soft part, and this scene has none");
  auto values = std::make_shared<SurfaceValues>(field.read(quantity, state, contacts, wishes.stretchLaw));
  std::vector<char> hidden;
  for (std::size_t i = 0; i < model.objects.size(); ++i) hidden.push_back(!layers.lookOf(static_cast<int>(i)).visible);
  const FieldRange shown = *range ? **range : rangeFor(quantity, fieldReach(quantity, *values, hidden));
  return std::optional(fieldLook(quantity, std::move(values), shown, QLocale::c()));
}

}  // namespace

void addColourOptions(CLI::App& command, PictureWishes& wishes) {
  command.add_option("--colour", wishes.colour,
                     "Colour the parts by what they bear, with a scale: stress (von Mises), strain (largest principal), pressure (in tissue) or contact "
                     "(contact force for each area)");
  command.add_option("--colour-range", wishes.colourRange, "Ends of the scale as LOW:HIGH, such as 0:50kPa or 0:20%; without it from the values");
}

Result<Done> checkColours(const PictureWishes& wishes) {
  if (wishes.colour.empty()) {
    if (!wishes.colourRange.empty()) return usageError("--colour-range goes with --colour only");
    return Done{};
  }
  const auto quantity = quantityNamed(wishes.colour);
  if (!quantity) return usageError("--colour wants stress, strain, pressure or contact, not “" + wishes.colour + "”");
  if (const auto range = rangeNamed(*quantity, wishes.colourRange); !range) return range.error();
  return Done{};
}

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
  Result<std::optional<FieldLook>> field = coloursOf(model, state, contacts, wishes, layers);
  if (!field) return field.error();
  layers.field = wishes.field ? wishes.field : std::move(*field);
  std::vector<Panel> panels = panelsOf(*sheet, model, layers, only < 0 ? std::string() : model.objects[only].id);
  if (panels.empty()) return usageError("there is nothing to show on this sheet");
  const int width = std::max(wishes.width / static_cast<int>(panels.size()), 1);
  const double aspect = static_cast<double>(width) / wishes.height;
  const Result<int> scope = scopeNamed(model, wishes.camera);
  if (!scope) return scope.error();
  if (*scope < 0 && (wishes.haze > 0 || wishes.bleeding > 0)) return usageError("--haze and --bleeding go with --camera scope only");
  Look look;
  Result<View> view = View();
  if (*scope >= 0) {
    ScopeSight sight = scopeSight(model, state.q, *scope, width, wishes.height);
    view = sight.view;
    sight.look.haze = wishes.haze;
    sight.look.bleeding = wishes.bleeding;
    look.scope = sight.look;
    for (Panel& panel : panels) panel.layers = throughScope(std::move(panel.layers), *scope);
  } else {
    view = chooseView(model, wishes.camera, box, aspect, !wishes.part.empty());
  }
  if (!view) return view.error();
  // One legend is enough: in the last panel that has colours.
  const auto last = std::find_if(panels.rbegin(), panels.rend(), [](const Panel& panel) { return panel.layers.visual; });
  for (auto panel = panels.rbegin(); panel != panels.rend(); ++panel)
    if (panel != last && panel->layers.field) panel->layers.field->title.clear();
  std::vector<Image> images;
  for (const Panel& panel : panels) {
    State shown = state;
    if (panel.q.size() > 0) shown.q = panel.q;
    Result<Image> image = renderPicture(model, shown, *view, panel.layers, width, wishes.height, look, contacts);
    if (!image) return image.error();
    images.push_back(std::move(*image));
  }
  return writePng(besideEachOther(images), wishes.out);
}

}  // namespace glenoid
