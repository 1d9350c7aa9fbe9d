// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <span>
#include <vector>

#include "simcore/collide/CollisionSurface.h"
#include "simcore/spatial/BoxTree.h"

namespace glenoid {

/// How deep a surface lies in itself, for PenetrationCheck; shares no code with the search but the exact crossing of a
/// ray (spatial/RayParity). A point of the surface is inside
/// where the winding number just in front of it, a millionth of the surface's size along its normal, is above zero: there a
/// second layer of the body is. A closed surface that does not cross itself has none, so one without crossing triangles is
/// done at once. The depth is the distance to the nearest triangle that the point lies behind, its own left out; so never more
/// than its own layer is thick there. Looks at every vertex and, of every edge
/// that crosses the surface or whose ends are both inside, at the stretches between its crossings, three samples on each.
/// Frames: W, m. Right for closed surfaces. Scratch only.
class SelfPenetration {
 public:
  using Found = std::function<void(const Vec3& point, double depth)>;
  /// `tree`: of the triangles' boxes as they lie now.
  void look(const CollisionSurface& surface, const BoxTree& tree, std::span<const Vec3> x, const Found& found);

 private:
  struct Crossing {
    int edge;
    double t;
  };
  bool crossings();
  int winding(const Vec3& p) const;
  bool inside(const Vec3& p, const Vec3& normal) const;
  double depthOf(const Vec3& x, const Vec3& normal, std::span<const int> own) const;
  std::array<Vec3, 3> corners(int t) const;
  Vec3 faceNormal(int t) const;

  const CollisionSurface* m_surface = nullptr;
  const BoxTree* m_tree = nullptr;
  std::span<const Vec3> m_x;
  std::vector<Crossing> m_crossings;
  std::vector<Vec3> m_normals;  ///< of vertices, unit
  std::vector<char> m_inside;   ///< vertices
};

}  // namespace glenoid
