// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/author/BuildJoint.h"

#include <algorithm>

#include "simcore/author/MakeCollision.h"
#include "simcore/author/MirrorJoint.h"
#include "simcore/author/NearCouplings.h"
#include "simcore/author/NodeCouplings.h"
#include "simcore/author/OwnFrame.h"
#include "simcore/embed/BandShape.h"
#include "simcore/mesh/MeshHealth.h"

namespace glenoid {
namespace {

Error inPart(Error error, const std::string& part) {
  if (error.place.part.empty()) error.place.part = part;
  return error;
}

/// makeCollision, where there is a frame as a function of the shape alone.
Result<TriMesh> collisionIn(const std::optional<OwnFrame>& own, const TriMesh& visual, int triangles) {
  if (!own) return makeCollision(visual, triangles);
  const auto mesh = makeCollision(inOwnOrder(own->toOwn(visual)), triangles);
  return mesh ? Result<TriMesh>(own->toW(*mesh)) : mesh;
}

Result<Part> surfacesOf(const PartRecipe& recipe, const std::optional<OwnFrame>& own) {
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
    auto simple = collisionIn(own, *recipe.visual, recipe.collisionTriangles);
    if (!simple) return inPart(simple.error(), recipe.id);
    part.collision = std::make_shared<const TriMesh>(std::move(*simple));
  }
  return part;
}

/// Cells that were cut in a joint's own frame. Those along a band are bent as the band is found in W, which differs by some 1e-6 of its
/// slope from how it is found in another frame: a run finds the cells again by that (embed/WholeCells).
TetMesh placedInW(TetMesh mesh, const OwnFrame& own, const TriMesh* bandInOwn, const TriMesh& visual_W) {
  if (!bandInOwn) return own.toW(mesh);
  const BandShape from = bandOf(*bandInOwn), to = bandOf(visual_W);
  for (Vec3& node : mesh.nodes) node = from.flattened(node);
  mesh = own.toW(mesh);
  for (Vec3& node : mesh.nodes) node = to.bent(node);
  return mesh;
}

Result<Done> cutVolume(const PartRecipe& recipe, const std::optional<OwnFrame>& own, Part& part) {
  if (recipe.kind == PartKind::Rigid) return Done{};
  part.elements = recipe.elements;
  // Cells along W's axes are cut in W; all others go with the joint. In its own frame "along the axes" is along its own.
  const bool inOwn = own && recipe.axes != GridAxes::World;
  const TriMesh visual = inOwn ? own->toOwn(*part.visual) : *part.visual;
  const TriMesh collision = inOwn ? own->toOwn(*part.collision) : *part.collision;
  const GridAxes axes = recipe.axes.value_or(GridAxes::World);
  const auto take = [&](TetMesh mesh, double cellSize) {
    if (inOwn) {
      // The joint holds the surface that the cells were cut of, rounded as that was.
      part.visual = std::make_shared<const TriMesh>(own->toW(visual));
      mesh = placedInW(std::move(mesh), *own, axes == GridAxes::Band ? &visual : nullptr, *part.visual);
    }
    part.volume = std::make_shared<const TetMesh>(std::move(mesh));
    part.cellSize = cellSize;
    return Done{};
  };
  if (recipe.cellSize > 0) {
    auto mesh = embedAlong(visual, collision, recipe.cellSize, axes);
    if (!mesh) return inPart(mesh.error(), recipe.id);
    return take(std::move(*mesh), recipe.cellSize);
  }
  auto choice = chooseCells(visual, collision, recipe.tetrahedra, axes);
  if (!choice) return inPart(choice.error(), recipe.id);
  return take(std::move(choice->mesh), choice->cellSize);
}

/// separateCollision in the joint's own frame.
Result<SeparationReport> separateInOwnFrame(Joint& joint, const OwnFrame& own, double clearance, int iterations) {
  const Joint before = own.toOwn(joint);
  Joint after = before;
  auto report = separateCollision(after, clearance, iterations);
  if (!report) return report;
  for (std::size_t i = 0; i < joint.parts.size(); ++i)
    if (after.parts[i].collision != before.parts[i].collision)
      joint.parts[i].collision = std::make_shared<const TriMesh>(own.toW(*after.parts[i].collision));
  return report;
}

}  // namespace

Result<Joint> buildJoint(const JointRecipe& recipe, const BuildProgress& progress, BuildReport* report) {
  if (const auto near = checkNearCouplings(recipe.parts, recipe.nearCouplings); !near) return near.error();
  Joint joint;
  joint.id = recipe.id;
  joint.name = recipe.name;
  joint.description = recipe.description;
  joint.side = recipe.side;
  joint.materials = recipe.materials;
  joint.couplings = recipe.couplings;
  joint.exclusions = recipe.exclusions;
  joint.bursae = recipe.bursae;
  joint.provenance = recipe.provenance;
  std::vector<const PartRecipe*> parts;
  for (const PartRecipe& part : recipe.parts) parts.push_back(&part);
  std::stable_sort(parts.begin(), parts.end(),
                   [](const PartRecipe* a, const PartRecipe* b) { return a->number < b->number; });
  // A start is trustworthy only where it does not depend on where the scan lies: then all that is derived from the surfaces
  // is derived in a frame of their own.
  std::optional<OwnFrame> own;
  if (recipe.start) {
    std::vector<std::shared_ptr<const TriMesh>> surfaces;
    for (const PartRecipe* part : parts) surfaces.push_back(part->visual);
    own = ownFrameOf(surfaces);
    joint.axes_W = own->own_W.R;
  }

  // Simplifying, separating and cutting cells take about equal shares of the time, freeing the start about as much as
  // all of that.
  const double sooner = 2.0 * static_cast<double>(parts.size()) + 1, pieces = recipe.start ? 2 * sooner : sooner;
  double done = 0;
  const auto goOn = [&](const std::string& part) { return !progress || progress(part, done++ / pieces); };
  const Error cancelled{Fault::Cancelled, {}, {}, "building a joint"};

  for (const PartRecipe* part : parts) {
    if (!goOn(part->id)) return cancelled;
    auto made = surfacesOf(*part, own);
    if (!made) return made.error();
    joint.parts.push_back(std::move(*made));
  }
  if (!goOn({})) return cancelled;
  SeparationReport separation;
  if (recipe.clearance > 0) {
    auto separated = own ? separateInOwnFrame(joint, *own, recipe.clearance, recipe.separationIterations)
                         : separateCollision(joint, recipe.clearance, recipe.separationIterations);
    if (!separated) return separated.error();
    separation = std::move(*separated);
  }
  for (std::size_t i = 0; i < parts.size(); ++i) {
    if (!goOn(parts[i]->id)) return cancelled;
    if (const auto cut = cutVolume(*parts[i], own, joint.parts[i]); !cut) return cut.error();
  }
  for (const NearCoupling& near : recipe.nearCouplings)
    if (const auto bound = addNearCoupling(joint, near); !bound) return bound.error();
  for (const NodeCoupling& wish : recipe.nodeCouplings)
    if (const auto bound = addNodeCoupling(joint, wish); !bound) return bound.error();
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
  return recipe.mirrored ? mirroredJoint(joint) : joint;
}

}  // namespace glenoid
