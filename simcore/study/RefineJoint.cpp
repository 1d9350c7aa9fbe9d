// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/study/RefineJoint.h"

#include <cassert>
#include <cmath>
#include <map>

#include "simcore/coupling/CarryNodes.h"
#include "simcore/embed/Bind.h"
#include "simcore/embed/Cells.h"
#include "simcore/mesh/Simplify.h"
#include "simcore/scene/CouplingHold.h"

namespace glenoid {
namespace {

/// Every triangle cut in four at the middles of its edges: the same shape, so any number of triangles can be asked for.
TriMesh subdivided(const TriMesh& mesh) {
  TriMesh fine;
  fine.vertices = mesh.vertices;
  fine.triangles.reserve(4 * mesh.triangles.size());
  std::map<std::array<int, 2>, int> middles;
  const auto middle = [&](int a, int b) {
    const std::array<int, 2> edge{std::min(a, b), std::max(a, b)};
    const auto [found, isNew] = middles.try_emplace(edge, static_cast<int>(fine.vertices.size()));
    if (isNew) fine.vertices.push_back(0.5 * (mesh.vertices[a] + mesh.vertices[b]));
    return found->second;
  };
  for (const auto& [a, b, c] : mesh.triangles) {
    const int ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
    fine.triangles.push_back({a, ab, ca});
    fine.triangles.push_back({ab, b, bc});
    fine.triangles.push_back({ca, bc, c});
    fine.triangles.push_back({ab, bc, ca});
  }
  return fine;
}

Result<std::shared_ptr<const TriMesh>> collisionOf(const Part& part, int triangles) {
  TriMesh surface = *part.visual;
  while (static_cast<int>(surface.triangles.size()) < triangles) surface = subdivided(surface);
  Result<TriMesh> simple = simplify(surface, triangles);
  if (!simple) return simple.error();
  return std::shared_ptr<const TriMesh>(std::make_shared<TriMesh>(std::move(*simple)));
}

Error inPart(Error error, const Part& part) {
  error.place.part = part.id;
  return error;
}

/// Finer cells for a soft part, along its principal axes, with the nodes that couplings hold; a rigid one has none.
Result<Done> cutFiner(Joint& joint, std::size_t index, double factor) {
  Part& part = joint.parts[index];
  if (part.kind == PartKind::Rigid) return Done{};
  const auto before = part.volume;
  const double cellBefore = cellEdgeOf(part);
  const double tets = static_cast<double>(part.volume->tets.size()) * factor;
  auto choice = chooseCells(*part.visual, *part.collision, static_cast<int>(std::lround(tets)), GridAxes::Principal);
  if (!choice) return inPart(choice.error(), part);
  part.volume = std::make_shared<TetMesh>(std::move(choice->mesh));
  part.cellSize = choice->cellSize;
  if (const auto carried = carryNodes(joint, part.id, *before, cellBefore); !carried) return carried.error();
  return Done{};
}

}  // namespace

Result<Joint> refineJoint(const Joint& joint, double factor, double clearance, const BuildProgress& progress) {
  if (!(factor >= 1)) return Error{Fault::OutOfRange, {}, {std::to_string(factor), "1", "inf"}, "refinement"};
  if (factor == 1) return joint;
  const double pieces = 2.0 * static_cast<double>(joint.parts.size());
  double done = 0;
  const auto goOn = [&](const Part& part) { return !progress || progress(part.id, done++ / pieces); };
  const Error cancelled{Fault::Cancelled, {}, {}, "refining a joint"};
  Joint fine = joint;
  for (Part& part : fine.parts) {
    if (!goOn(part)) return cancelled;
    for (const Region& region : part.regions)
      if (region.surface == SurfaceKind::Collision)
        return Error{Fault::Unusable, {"", "", part.id, {}}, {"a region on the collision surface"}, "refining a joint"};
    const double triangles = static_cast<double>(part.collision->triangles.size()) * std::pow(factor, 2.0 / 3.0);
    auto collision = collisionOf(part, static_cast<int>(std::lround(triangles)));
    if (!collision) return inPart(collision.error(), part);
    part.collision = std::move(*collision);
  }
  if (const auto separated = separateCollision(fine, clearance); !separated) return separated.error();
  for (std::size_t i = 0; i < fine.parts.size(); ++i) {
    if (!goOn(fine.parts[i])) return cancelled;
    if (const auto cut = cutFiner(fine, i, factor); !cut) return cut.error();
  }
  return fine;
}

Result<Joint> refineCells(const Joint& joint, double factor, const BuildProgress& progress) {
  if (!(factor >= 1)) return Error{Fault::OutOfRange, {}, {std::to_string(factor), "1", "inf"}, "refinement"};
  Joint fine = joint;
  if (factor == 1) return fine;
  double done = 0;
  for (std::size_t i = 0; i < fine.parts.size(); ++i) {
    if (progress && !progress(fine.parts[i].id, done++ / static_cast<double>(fine.parts.size()))) return Error{Fault::Cancelled, {}, {}, "refining cells"};
    if (const auto cut = cutFiner(fine, i, factor); !cut) return cut.error();
  }
  return fine;
}

State carryToRefined(const Model& coarse, const State& state, const Model& fine) {
  assert(coarse.objects.size() == fine.objects.size());
  State result = fine.start;
  for (std::size_t i = 0; i < coarse.objects.size(); ++i) {
    const ObjectLayout &from = coarse.objects[i].layout, &to = fine.objects[i].layout;
    assert(from.rigid == to.rigid && from.free == to.free);
    if (from.rigid) {
      result.q.segment(to.qOffset, to.qSize) = state.q.segment(from.qOffset, from.qSize);
      result.v.segment(to.vOffset, to.vSize) = state.v.segment(from.vOffset, from.vSize);
      continue;
    }
    const std::vector<VertexBinding> bindings = bindToTets(*coarse.objects[i].volume, fine.objects[i].volume->nodes);
    std::vector<Vec3> nodes(from.nodeCount), velocities(from.nodeCount, Vec3::Zero());
    for (int node = 0; node < from.nodeCount; ++node) {
      nodes[node] = state.q.segment<3>(from.qOffset + 3 * node);
      if (from.free) velocities[node] = state.v.segment<3>(from.vOffset + 3 * node);
    }
    for (int node = 0; node < to.nodeCount; ++node) {
      result.q.segment<3>(to.qOffset + 3 * node) = boundPosition(bindings[node], nodes);
      if (to.free) result.v.segment<3>(to.vOffset + 3 * node) = boundPosition(bindings[node], velocities);
    }
  }
  result.hands = state.hands;
  result.time = state.time;
  result.step = state.step;
  return result;
}

}  // namespace glenoid
