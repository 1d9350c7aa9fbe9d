// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/scene/RecipeFile.h"

#include <algorithm>

#include "simcore/file/Schema.h"
#include "simcore/scene/JointCheck.h"
#include "simcore/scene/RecipeRegions.h"
#include "simcore/scene/SceneJson.h"
#include "simcore/scene/SceneWords.h"

namespace glenoid {
namespace {

using namespace scene_json;

/// Everything but the meshes.
PartRecipe toPartRecipe(const JsonValue& json) {
  PartRecipe part;
  part.id = json["id"].text();
  part.number = static_cast<int>(json["number"].integer());
  part.name = json["name"].text();
  part.kind = json["kind"].text() == "rigid" ? PartKind::Rigid : PartKind::Soft;
  if (json.find("color")) part.color = toColor(json["color"]);
  part.visualFile = json["visual"].text();
  part.collisionFile = json["collision"].text();
  part.collisionTriangles = static_cast<int>(json["collisionTriangles"].integer());
  part.tetrahedra = static_cast<int>(json["tetrahedra"].integer());
  part.cellSize = json["cellSize"].number();
  part.elements = scene_words::valueOf(scene_words::kElements, json["elements"].text(), part.elements);
  if (json.find("axes")) part.axes = scene_words::valueOf(scene_words::kGridAxes, json["axes"].text(), GridAxes::World);
  part.materials = vectorOf(json["materials"], toMaterialUse);
  part.regions = vectorOf(json["regions"], toRegion);
  part.landmarks = vectorOf(json["landmarks"], toLandmark);
  return part;
}

NearCoupling toNearCoupling(const JsonValue& json) {
  NearCoupling near;
  near.coupling = toCoupling(json);
  near.within = json["within"].number();
  near.centre_W = toVec3(json["ball"]["centre"]);
  near.radius = json["ball"]["radius"].number();
  return near;
}

NodeCoupling toNodeCoupling(const JsonValue& json) {
  NodeCoupling wish;
  wish.coupling = toCoupling(json);
  const JsonValue& nodes = json["nodes"];
  wish.points_W = vectorOf(nodes, [](const JsonValue& x) { return toVec3(x); });
  if (const JsonValue* within = nodes.find("within")) wish.within = within->number();
  wish.centre_W = toVec3(nodes["ball"]["centre"]);
  wish.radius = nodes["ball"]["radius"].number();
  return wish;
}

StartWishes toStart(const JsonValue& json) {
  StartWishes start;
  start.clearance = json["clearance"].number(start.clearance);
  start.handles = static_cast<int>(json["handles"].integer(start.handles));
  start.iterations = static_cast<int>(json["iterations"].integer(start.iterations));
  start.refinements = static_cast<int>(json["refinements"].integer(start.refinements));
  start.parts = toTexts(json["parts"]);
  return start;
}

JointRecipe toRecipe(const JsonValue& json) {
  JointRecipe recipe;
  recipe.id = json["id"].text();
  recipe.name = json["name"].text();
  recipe.description = json["description"].text();
  recipe.side = scene_words::valueOf(scene_words::kJointSides, json["side"].text(), recipe.side);
  recipe.materials = vectorOf(json["materials"], toMaterial);
  recipe.parts = vectorOf(json["parts"], toPartRecipe);
  for (const JsonValue& coupling : json["couplings"].items()) {
    if (coupling.find("nodes")) recipe.nodeCouplings.push_back(toNodeCoupling(coupling));
    else if (coupling.find("within")) recipe.nearCouplings.push_back(toNearCoupling(coupling));
    else recipe.couplings.push_back(toCoupling(coupling));
  }
  recipe.exclusions = vectorOf(json["exclusions"], toExclusion);
  recipe.bursae = vectorOf(json["bursae"], toBursa);
  recipe.provenance = toProvenance(json["provenance"]);
  recipe.clearance = json["clearance"].number(recipe.clearance);
  recipe.separationIterations =
      static_cast<int>(json["separationIterations"].integer(recipe.separationIterations));
  recipe.mirrored = json["mirror"].boolean(false);
  if (const JsonValue* start = json.find("start")) recipe.start = toStart(*start);
  return recipe;
}

/// The joint it will become, as far as ids and references go: they are judged by the same rules.
Joint withoutMeshes(const JointRecipe& recipe, const JsonValue& json) {
  Joint joint;
  joint.materials = recipe.materials;
  joint.couplings = vectorOf(json["couplings"], toCoupling);  // in the order of the file, for the places of errors
  joint.exclusions = recipe.exclusions;
  joint.bursae = recipe.bursae;
  for (const PartRecipe& from : recipe.parts) {
    Part part;
    part.id = from.id;
    part.number = from.number;
    part.kind = from.kind;
    part.materials = from.materials;
    part.regions = from.regions;
    part.landmarks = from.landmarks;
    joint.parts.push_back(std::move(part));
  }
  for (std::size_t i = 0; i < joint.couplings.size(); ++i) {  // what will be found is judged as if it were there
    Coupling& coupling = joint.couplings[i];
    if (json["couplings"][i].find("nodes")) coupling.nodesA = {0};
    if (!json["couplings"][i].find("within")) continue;
    if (coupling.regionA.empty()) coupling.regionA = coupling.id;
    const int part = findPart(joint, coupling.partA);
    if (part >= 0) joint.parts[part].regions.push_back({coupling.id, {}, {}, SurfaceKind::Visual, {}});
  }
  return joint;
}

/// Letters (of any script), digits, '-', '_' and '.', as the schema says: ids become names of files, of columns and of groups.
bool isId(const std::string& id) {
  if (id == "." || id == "..") return false;
  return std::all_of(id.begin(), id.end(), [](char c) {
    return static_cast<unsigned char>(c) >= 0x80 || (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '-' || c == '_' || c == '.';
  });
}

/// Every id that the recipe gives, wherever it stands.
Result<Done> checkIds(const JsonValue& json, const std::string& pointer, const std::string& file) {
  for (std::size_t i = 0; i < json.items().size(); ++i)
    if (const auto good = checkIds(json.items()[i], pointerTo(pointer, i), file); !good) return good;
  for (const auto& [key, value] : json.members()) {
    if (key == "id" && value.isText() && !isId(value.text())) {
      std::string shown = value.text();
      for (char& c : shown)
        if (static_cast<unsigned char>(c) < ' ') c = ' ';  // a sentence is one line
      return Error{Fault::SchemaMismatch,
                   {file, pointer + "/id", {}, {}},
                   {"“" + shown + "” is no id, which has letters, digits, “-”, “_” and “.” only; what people read goes into “name”"},
                   "id"};
    }
    if (const auto good = checkIds(value, pointerTo(pointer, key), file); !good) return good;
  }
  return Done{};
}

Result<Done> checkWishes(const PartRecipe& part, const std::string& pointer, const std::string& file) {
  const bool wished = part.tetrahedra > 0 || part.cellSize > 0;
  const auto fail = [&](const char* what) {
    return Error{Fault::Unusable, {file, pointer, part.id, {}}, {what}, {}};
  };
  if (part.kind == PartKind::Soft && !wished) return fail("a soft part needs tetrahedra or cellSize");
  if (part.kind == PartKind::Rigid && wished) return fail("a rigid part has neither tetrahedra nor cellSize");
  if (part.kind == PartKind::Rigid && part.elements != Elements::Tetrahedra) return fail("a rigid part has no elements");
  return Done{};
}

}  // namespace

Result<JointRecipe> loadRecipe(const std::string& path, const std::string& meshes, std::vector<SourceReport>* reports) {
  const Result<JsonValue> json = readDocument(path, Schema::Recipe);
  if (!json) return json.error();
  if (const auto good = checkIds(*json, "", path); !good) return good.error();
  JointRecipe recipe = toRecipe(*json);
  if (const auto good = joint_check::checkValues(withoutMeshes(recipe, *json), path); !good) {
    Error error = good.error();
    if (error.place.pointer.ends_with("/nodesA")) error.place.pointer.pop_back();  // a recipe says where, not which
    return error;
  }
  RecipeSurfaces surfaces(meshes, (*json)["source"]);
  for (std::size_t i = 0; i < recipe.parts.size(); ++i) {
    PartRecipe& part = recipe.parts[i];
    const std::string pointer = pointerTo("/parts", i);
    if (const auto good = checkWishes(part, pointer, path); !good) return good.error();
    const JsonValue& source = (*json)["parts"][i]["source"];
    auto visual = surfaces.load(part.visualFile, source, {path, pointer + "/visual", part.id, {}}, true);
    if (!visual) return visual.error();
    part.visual = std::move(*visual);
    const auto size = static_cast<long long>(part.visual->triangles.size());
    for (std::size_t r = 0; r < part.regions.size(); ++r) {
      if (part.regions[r].triangles.empty()) continue;
      const TriangleRun& run = part.regions[r].triangles.back();  // ascending: the last one reaches farthest
      const long long last = static_cast<long long>(run.first) + run.count - 1;
      if (last >= size)
        return Error{Fault::BadIndex,
                     {path, pointerTo(pointer + "/regions", r) + "/triangles", part.id, {}},
                     {std::to_string(last), std::to_string(size)},
                     {}};
    }
    if (part.collisionFile.empty()) continue;
    auto collision = surfaces.load(part.collisionFile, source, {path, pointer + "/collision", part.id, {}}, false);
    if (!collision) return collision.error();
    part.collision = std::move(*collision);
  }
  if (const auto filled = fillRegions(recipe.parts, *json, path); !filled) return filled.error();
  if (reports) *reports = surfaces.reports();
  return recipe;
}

}  // namespace glenoid
