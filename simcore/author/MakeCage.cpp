// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/author/MakeCage.h"

#include <algorithm>

#include "simcore/mesh/Cleanup.h"
#include "simcore/mesh/Isosurface.h"
#include "simcore/mesh/MeshHealth.h"
#include "simcore/mesh/Simplify.h"
#include "simcore/mesh/TetTools.h"
#include "simcore/spatial/TriangleTree.h"

namespace glenoid {
namespace {

/// Surface at a distance from the mesh's outside.
TriMesh offsetSurface(const TriangleTree& skin, const Box3& box, double offset, double step) {
  const Vec3 margin = Vec3::Constant(offset + 2 * step);
  const auto field = [&](const Vec3& p) {  // exact only where it is near zero
    const double reach = offset + 2 * step, distance = std::min(skin.closest(p, reach).distance, reach);
    if (distance <= offset) return distance - offset;
    return skin.inside(p) ? -offset : distance - offset;
  };
  return largestComponent(isosurface(field, Box3(box.min() - margin, box.max() + margin), step));
}

bool holdsAll(const TriMesh& cage, const std::vector<Vec3>& points) {
  const TriangleTree tree(cage);
  return std::all_of(points.begin(), points.end(), [&](const Vec3& p) { return tree.inside(p); });
}

}  // namespace

Result<Cage> makeCage(const Part& part, int handles) {
  if (part.kind != PartKind::Soft || !part.volume || part.volume->tets.empty())
    return Error{Fault::Unusable, {{}, {}, part.id, {}}, {"only a soft part with tetrahedra can have a cage"}, {}};
  if (handles < 8 || handles > 2000)
    return Error{Fault::OutOfRange, {{}, {}, part.id, {}}, {std::to_string(handles), "8", "2000"}, {}};
  const TriMesh boundary = compact(boundaryOf(*part.volume));
  const TriangleTree skin(boundary);
  const Box3 box = boundsOf(boundary);
  const double size = box.diagonal().norm();
  // The coarser the cage, the farther its flat faces cut into what they go around.
  for (double offset = size / 40; offset < size / 4; offset *= 1.3) {
    const double step = std::max(size / 60, offset / 3);
    const TriMesh fine = offsetSurface(skin, box, offset, step);
    const MeshHealth health = healthOf(fine);
    if (!health.closed() || !health.manifold()) continue;
    // V − E + F = 2 − 2 genus and 2 E = 3 F: this many triangles have about that many vertices.
    const auto coarse = simplify(fine, 2 * (handles - 2 + 2 * health.genus), {.keepVolume = false});
    if (!coarse || !holdsAll(*coarse, part.volume->nodes)) continue;
    Cage cage;
    cage.id = part.id + "-cage";
    cage.part = part.id;
    cage.triangles = coarse->triangles;
    cage.rest_W = cage.moved_W = coarse->vertices;
    return cage;
  }
  return Error{Fault::Unusable, {{}, {}, part.id, {}}, {"no cage of this size holds the whole part"}, {}};
}

void putCage(Joint& joint, Cage cage) {
  joint.startProof.reset();
  for (Cage& old : joint.cages)
    if (old.part == cage.part) {
      old = std::move(cage);
      return;
    }
  joint.cages.push_back(std::move(cage));
}

}  // namespace glenoid
