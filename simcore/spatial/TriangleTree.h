// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <limits>
#include <optional>
#include <vector>

#include "simcore/base/Math.h"
#include "simcore/mesh/TriMesh.h"
#include "simcore/spatial/BoxTree.h"

namespace glenoid {

/// Where a ray first meets a surface.
struct RayHit {
  double distance = 0;        ///< m along the unit direction
  Vec3 point = Vec3::Zero();  ///< same frame as the mesh
  int triangle = -1;
  Vec3 barycentric = Vec3::UnitX();  ///< weights of the triangle's corners, in their order
  Vec3 normal = Vec3::UnitY();       ///< unit, outward by the winding
};

/// Answers questions about one unmoving triangle mesh: nearest point, inside, rays, boxes. Keeps its own copy
/// of the mesh. Wrong for a surface that moves (see collide). Same frame and unit as the mesh. An empty mesh
/// is allowed: everything is infinitely far. Indices must lie inside the mesh. Any number of threads may ask.
class TriangleTree {
 public:
  explicit TriangleTree(const TriMesh& mesh);

  struct Closest {
    double distance = std::numeric_limits<double>::infinity();  ///< m, ≥ 0
    Vec3 point = Vec3::Zero();
    int triangle = -1;  ///< −1: nothing within reach; of several equally near, the lowest
    Vec3 barycentric = Vec3::UnitX();
  };
  /// Nearest point of the surface, if any nearer than `reach`.
  Closest closest(const Vec3& point, double reach = std::numeric_limits<double>::infinity()) const;

  /// Whether a point is enclosed, for a closed mesh: parity of crossings of an axis ray, made watertight by
  /// one rule for shared edges, so that no ray slips between two triangles. A point on the surface is either.
  bool inside(const Vec3& point) const;

  /// Distance, negative inside. Infinity for an empty mesh.
  double signedDistance(const Vec3& point) const;

  /// Triangles whose boxes meet `box` (touching counts), ascending. `out` is cleared first.
  void overlapping(const Box3& box, std::vector<int>& out) const;

  /// First hit from either side within `maxDistance`; `direction` need not be unit. None for a zero
  /// direction.
  std::optional<RayHit> cast(const Vec3& origin, const Vec3& direction,
                             double maxDistance = std::numeric_limits<double>::infinity()) const;

  const TriMesh& mesh() const { return m_mesh; }

 private:
  TriMesh m_mesh;
  BoxTree m_tree;
};

}  // namespace glenoid
