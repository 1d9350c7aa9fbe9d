// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/author/MakeCage.h"

#include <algorithm>
#include <cmath>

#include "simcore/author/OwnFrame.h"
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

/// Pushes faces outwards where points lie outside or nearer than `margin` to them.
void holdAll(TriMesh& cage, const std::vector<Vec3>& points, double margin) {
  for (int round = 0; round < 60; ++round) {
    const TriangleTree tree(cage);
    std::vector<Vec3> push(cage.vertices.size(), Vec3::Zero());
    bool asked = false;
    for (const Vec3& p : points) {
      const auto near = tree.closest(p);
      const double depth = tree.inside(p) ? near.distance : -near.distance;
      if (depth >= margin) continue;
      const auto& t = cage.triangles[near.triangle];
      const Vec3 normal =
          (cage.vertices[t[1]] - cage.vertices[t[0]]).cross(cage.vertices[t[2]] - cage.vertices[t[0]]).normalized();
      for (const int corner : t)
        if (push[corner].norm() < margin - depth) push[corner] = (margin - depth) * normal;
      asked = true;
    }
    if (!asked) return;
    for (std::size_t v = 0; v < push.size(); ++v) cage.vertices[v] += 0.7 * push[v];
  }
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
  // In the part's own frame: the grid of the level set, and what is cut from it, go with the part.
  const OwnFrame own = ownFrameOf({part.visual});
  const TriMesh boundary = own.toOwn(compact(boundaryOf(*part.volume)));
  std::vector<Vec3> nodes;
  for (const Vec3& node : part.volume->nodes) nodes.push_back(own.own_W * node);
  const TriangleTree skin(boundary);
  const Box3 box = boundsOf(boundary);
  const double size = box.diagonal().norm();
  // A level set has about two vertices for each square of the grid that it crosses.
  const double step = std::min(size / 40, std::sqrt(healthOf(boundary).area / (2.0 * handles)));
  // The coarser the cage, the farther its flat faces cut into what they go around.
  for (double offset = size / 30; offset < size / 4; offset *= 1.4) {
    TriMesh fine = offsetSurface(skin, box, offset, step);
    for (int round = 0; round < 3; ++round) fine.vertices = neighbourMeans(fine);  // marching leaves slivers
    const MeshHealth health = healthOf(fine);
    if (!health.closed() || !health.manifold()) continue;
    // V − E + F = 2 − 2 genus and 2 E = 3 F: this many triangles have about that many vertices.
    SimplifyOptions options;
    options.keepVolume = false;
    auto coarse = simplify(fine, 2 * (handles - 2 + 2 * health.genus), options);
    if (!coarse) continue;
    holdAll(*coarse, nodes, 0.3 * offset);
    if (!healthOf(*coarse).healthy() || countSelfIntersections(*coarse) > 0 || !holdsAll(*coarse, nodes)) continue;
    Cage cage;
    cage.id = part.id + "-cage";
    cage.part = part.id;
    const TriMesh placed = own.toW(*coarse);
    cage.triangles = placed.triangles;
    cage.rest_W = cage.moved_W = placed.vertices;
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
