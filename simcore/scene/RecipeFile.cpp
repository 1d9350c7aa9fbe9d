// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/scene/RecipeFile.h"

#include <filesystem>
#include <map>

#include "simcore/file/Ply.h"
#include "simcore/file/Schema.h"
#include "simcore/scene/JointCheck.h"
#include "simcore/scene/SceneJson.h"

namespace glenoid {
namespace {

namespace fs = std::filesystem;
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
  part.axes = json["axes"].text() == "principal" ? GridAxes::Principal : GridAxes::World;
  part.materials = vectorOf(json["materials"], toMaterialUse);
  part.regions = vectorOf(json["regions"], toRegion);
  part.landmarks = vectorOf(json["landmarks"], toLandmark);
  return part;
}

JointRecipe toRecipe(const JsonValue& json) {
  JointRecipe recipe;
  recipe.id = json["id"].text();
  recipe.name = json["name"].text();
  recipe.materials = vectorOf(json["materials"], toMaterial);
  recipe.parts = vectorOf(json["parts"], toPartRecipe);
  recipe.couplings = vectorOf(json["couplings"], toCoupling);
  recipe.exclusions = vectorOf(json["exclusions"], toExclusion);
  recipe.bursae = vectorOf(json["bursae"], toBursa);
  recipe.provenance = toProvenance(json["provenance"]);
  recipe.clearance = json["clearance"].number(recipe.clearance);
  recipe.separationIterations =
      static_cast<int>(json["separationIterations"].integer(recipe.separationIterations));
  return recipe;
}

/// The joint it will become, as far as ids and references go: they are judged by the same rules.
Joint withoutMeshes(const JointRecipe& recipe) {
  Joint joint;
  joint.materials = recipe.materials;
  joint.couplings = recipe.couplings;
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
  return joint;
}

Result<Done> checkWishes(const PartRecipe& part, const std::string& pointer, const std::string& file) {
  const bool wished = part.tetrahedra > 0 || part.cellSize > 0;
  const auto fail = [&](const char* what) {
    return Error{Fault::Unusable, {file, pointer, part.id, {}}, {what}, {}};
  };
  if (part.kind == PartKind::Soft && !wished) return fail("a soft part needs tetrahedra or cellSize");
  if (part.kind == PartKind::Rigid && wished) return fail("a rigid part has neither tetrahedra nor cellSize");
  return Done{};
}

using Surfaces = std::map<std::string, std::shared_ptr<const TriMesh>>;

Result<std::shared_ptr<const TriMesh>> loadSurface(const std::string& name, const std::string& meshes,
                                                   const Place& place, Surfaces& known) {
  if (!staysInside(name)) return Error{Fault::BadReference, place, {name}, {}};
  if (const auto found = known.find(name); found != known.end()) return found->second;
  Result<TriMesh> mesh = readPly((fs::path(meshes) / name).string());
  if (!mesh) {
    mesh.error().place.part = place.part;
    return mesh.error();
  }
  return known[name] = std::make_shared<const TriMesh>(std::move(*mesh));
}

}  // namespace

Result<JointRecipe> loadRecipe(const std::string& path, const std::string& meshes) {
  const Result<JsonValue> json = readDocument(path, Schema::Recipe);
  if (!json) return json.error();
  JointRecipe recipe = toRecipe(*json);
  if (const auto good = joint_check::checkValues(withoutMeshes(recipe), path); !good) return good.error();
  Surfaces known;
  for (std::size_t i = 0; i < recipe.parts.size(); ++i) {
    PartRecipe& part = recipe.parts[i];
    const std::string pointer = pointerTo("/parts", i);
    if (const auto good = checkWishes(part, pointer, path); !good) return good.error();
    auto visual = loadSurface(part.visualFile, meshes, {path, pointer + "/visual", part.id, {}}, known);
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
    auto collision =
        loadSurface(part.collisionFile, meshes, {path, pointer + "/collision", part.id, {}}, known);
    if (!collision) return collision.error();
    part.collision = std::move(*collision);
  }
  return recipe;
}

}  // namespace glenoid
