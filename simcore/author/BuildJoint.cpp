// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/author/BuildJoint.h"

#include <algorithm>

#include "simcore/author/NearCouplings.h"
#include "simcore/mesh/MeshHealth.h"
#include "simcore/mesh/Simplify.h"
#include "simcore/repair/Untangled.h"

namespace glenoid {
namespace {

Error inPart(Error error, const std::string& part) {
  if (error.place.part.empty()) error.place.part = part;
  return error;
}

Result<Part> surfacesOf(const PartRecipe& recipe) {
  if (!recipe.visual)
    return Error{Fault::BadMesh, {{}, {}, recipe.id, {}}, {"no visual surface"}, "recipe of a part"};
  Part part;
  part.id = recipe.id;
  part.number = recipe.number;
  part.name = recipe.name;
  part.kind = recipe.kind;
  part.color = recipe.color;
  part.materials = recipe.materials;
  part.regions = recipe.regions;
  part.landmarks = recipe.landmarks;
  part.visual = recipe.visual;
  if (const auto closed = requireClosed(*recipe.visual, recipe.id); !closed) return closed.error();
  if (recipe.collision) {
    if (const auto closed = requireClosed(*recipe.collision, recipe.id); !closed) return closed.error();
    part.collision = recipe.collision;
  } else if (recipe.collisionTriangles == 0) {
    part.collision = recipe.visual;
  } else {
    auto simple = simplify(*recipe.visual, recipe.collisionTriangles);
    if (!simple) return inPart(simple.error(), recipe.id);
    part.collision = std::make_shared<const TriMesh>(untangled(std::move(*simple)));
  }
  return part;
}

Result<Done> cutVolume(const PartRecipe& recipe, Part& part) {
  if (recipe.kind == PartKind::Rigid) return Done{};
  part.elements = recipe.elements;
  if (recipe.cellSize > 0) {
    auto mesh = embedAlong(*part.visual, *part.collision, recipe.cellSize, recipe.axes);
    if (!mesh) return inPart(mesh.error(), recipe.id);
    part.volume = std::make_shared<const TetMesh>(std::move(*mesh));
    part.cellSize = recipe.cellSize;
    return Done{};
  }
  auto choice = chooseCells(*part.visual, *part.collision, recipe.tetrahedra, recipe.axes);
  if (!choice) return inPart(choice.error(), recipe.id);
  part.volume = std::make_shared<const TetMesh>(std::move(choice->mesh));
  part.cellSize = choice->cellSize;
  return Done{};
}

}  // namespace

Result<Joint> buildJoint(const JointRecipe& recipe, const BuildProgress& progress, BuildReport* report) {
  if (const auto near = checkNearCouplings(recipe.parts, recipe.nearCouplings); !near) return near.error();
  Joint joint;
  joint.id = recipe.id;
  joint.name = recipe.name;
  joint.materials = recipe.materials;
  joint.couplings = recipe.couplings;
  joint.exclusions = recipe.exclusions;
  joint.bursae = recipe.bursae;
  joint.provenance = recipe.provenance;
  std::vector<const PartRecipe*> parts;
  for (const PartRecipe& part : recipe.parts) parts.push_back(&part);
  std::stable_sort(parts.begin(), parts.end(),
                   [](const PartRecipe* a, const PartRecipe* b) { return a->number < b->number; });

  // Simplifying, separating and cutting cells take about equal shares of the time, freeing the start about as much as
  // all of that.
  const double sooner = 2.0 * static_cast<double>(parts.size()) + 1, pieces = recipe.start ? 2 * sooner : sooner;
  double done = 0;
  const auto goOn = [&](const std::string& part) { return !progress || progress(part, done++ / pieces); };
  const Error cancelled{Fault::Cancelled, {}, {}, "building a joint"};

  for (const PartRecipe* part : parts) {
    if (!goOn(part->id)) return cancelled;
    auto made = surfacesOf(*part);
    if (!made) return made.error();
    joint.parts.push_back(std::move(*made));
  }
  if (!goOn({})) return cancelled;
  SeparationReport separation;
  if (recipe.clearance > 0) {
    auto separated = separateCollision(joint, recipe.clearance, recipe.separationIterations);
    if (!separated) return separated.error();
    separation = std::move(*separated);
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!goOn(parts[i]->id)) return cancelled;
    if (const auto cut = cutVolume(*parts[i], joint.parts[i]); !cut) return cut.error();
  }
  for (const NearCoupling& near : recipe.nearCouplings)
    if (const auto bound = addNearCoupling(joint, near); !bound) return bound.error();
  std::optional<SeparationOutcome> start;
  if (recipe.start) {
    auto freed = separateStart(joint, *recipe.start, [&](double share, int) {
      return !progress || progress({}, (sooner + share * (pieces - sooner)) / pieces);
    });
    if (!freed) return freed.error();
    start = std::move(*freed);
  }
  if (report) {
    report->start = std::move(start);
    report->separation = std::move(separation);
    report->parts.clear();
    for (const Part& part : joint.parts)
      report->parts.push_back({part.id, static_cast<int>(part.visual->triangles.size()),
                               static_cast<int>(part.collision->triangles.size()),
                               part.volume ? static_cast<int>(part.volume->tets.size()) : 0,
                               countSelfIntersections(*part.collision)});
  }
  return joint;
}

}  // namespace glenoid
