// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/scene/RegionNear.h"

#include <limits>

#include "simcore/spatial/TriangleTree.h"

namespace glenoid {

std::vector<int> pointsNear(std::span<const Vec3> points_W, const TriangleTree& other, double distance) {
  std::vector<int> near;
  const Box3 box = boundsOf(other.mesh());
  if (box.isEmpty()) return near;
  // The tree answers what is nearer than its reach; "within" counts what is as far.
  const double reach =
      distance * (1 + 4 * std::numeric_limits<double>::epsilon()) + std::numeric_limits<double>::min();
  for (std::size_t i = 0; i < points_W.size(); ++i) {
    const Vec3& point = points_W[i];
    if (box.squaredExteriorDistance(point) > reach * reach) continue;
    if (other.closest(point, reach).triangle >= 0 || (box.contains(point) && other.inside(point)))
      near.push_back(static_cast<int>(i));
  }
  return near;
}

std::vector<int> trianglesNear(const TriMesh& surface, const TriangleTree& other, double distance) {
  std::vector<Vec3> centres;
  for (const auto& corners : surface.triangles)
    centres.push_back((surface.vertices[corners[0]] + surface.vertices[corners[1]] + surface.vertices[corners[2]]) / 3);
  return pointsNear(centres, other, distance);
}

std::vector<int> trianglesNear(const TriMesh& surface, const TriMesh& other, double distance) {
  return trianglesNear(surface, TriangleTree(other), distance);
}

}  // namespace glenoid
