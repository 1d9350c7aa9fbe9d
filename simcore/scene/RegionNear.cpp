// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/scene/RegionNear.h"

#include <limits>

#include "simcore/spatial/TriangleTree.h"

namespace glenoid {

std::vector<int> trianglesNear(const TriMesh& surface, const TriangleTree& other, double distance) {
  std::vector<int> near;
  const Box3 box = boundsOf(other.mesh());
  if (box.isEmpty()) return near;
  // The tree answers what is nearer than its reach; "within" counts what is as far.
  const double reach =
      distance * (1 + 4 * std::numeric_limits<double>::epsilon()) + std::numeric_limits<double>::min();
  for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
    const auto& corners = surface.triangles[t];
    const Vec3 centre =
        (surface.vertices[corners[0]] + surface.vertices[corners[1]] + surface.vertices[corners[2]]) / 3;
    if (box.squaredExteriorDistance(centre) > reach * reach) continue;
    if (other.closest(centre, reach).triangle >= 0 || (box.contains(centre) && other.inside(centre)))
      near.push_back(static_cast<int>(t));
  }
  return near;
}

std::vector<int> trianglesNear(const TriMesh& surface, const TriMesh& other, double distance) {
  return trianglesNear(surface, TriangleTree(other), distance);
}

}  // namespace glenoid
