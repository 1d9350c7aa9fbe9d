// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/scene/Start.h"

#include "simcore/embed/Bind.h"
#include "simcore/embed/CageWeights.h"

namespace glenoid {

Result<std::vector<Vec3>> startNodes(const Joint& joint, const Part& part) {
  const Cage* cage = findCage(joint, part.id);
  if (!cage || cage->moved_W == cage->rest_W) return part.volume->nodes;
  const Result<CageWeights> weights = cageWeights({cage->rest_W, cage->triangles}, part.volume->nodes);
  if (!weights) {
    Error error = weights.error();
    error.place.part = part.id;
    return error;
  }
  return followCage(*weights, part.volume->nodes, cage->rest_W, cage->moved_W);
}

Result<TriMesh> startSurface(const Joint& joint, const Part& part, SurfaceKind kind) {
  const TriMesh& rest = kind == SurfaceKind::Visual ? *part.visual : *part.collision;
  if (part.kind == PartKind::Rigid || !findCage(joint, part.id)) return rest;
  const auto nodes = startNodes(joint, part);
  if (!nodes) return nodes.error();
  TriMesh surface = rest;
  const std::vector<VertexBinding> bound = bindToTets(*part.volume, rest.vertices);
  for (std::size_t v = 0; v < bound.size(); ++v) surface.vertices[v] = boundPosition(bound[v], *nodes);
  return surface;
}

}  // namespace glenoid
