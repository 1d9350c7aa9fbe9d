// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <memory>
#include <span>
#include <vector>

#include "simcore/collide/CollisionSurface.h"

namespace glenoid {

/// The deepest point of one surface inside another.
struct Penetration {
  double depth = 0;           ///< m, ≥ 0: distance from `point` to the other surface; of a surface with itself: SelfPenetration
  int pair = -1;              ///< index of the CollisionPair; −1: nothing is inside anything
  Vec3 point = Vec3::Zero();  ///< W
};

/// Measures penetration independently of ProximityFinder: shares neither its features nor its sign. A point
/// is inside by counting the triangles that a ray crosses. Looks at every vertex, and at every edge that
/// meets the other surface or whose ends are both inside, along its inside stretches (three samples on each).
/// A vertex or an edge all of whose triangles are skipped does not count, nor does a point whose nearest
/// triangle of the other surface is skipped: it is where the joint says that the parts are one, or
/// perforated. Frames: W, m. Right for closed surfaces. Allocates little after the first call. One thread at
/// a time.
class PenetrationCheck {
 public:
  PenetrationCheck(std::vector<std::shared_ptr<const CollisionSurface>> surfaces,
                   std::vector<CollisionPair> pairs);
  ~PenetrationCheck();
  PenetrationCheck(PenetrationCheck&&) noexcept;
  PenetrationCheck& operator=(PenetrationCheck&&) noexcept;

  /// positions[s] holds one entry for each vertex of surface s. allowed[p] is taken off every depth of pair p (m): what
  /// lies no deeper is where it may be; empty: nothing.
  Penetration deepest(std::span<const std::span<const Vec3>> positions, std::span<const double> allowed = {});

  /// The same for every pair by itself; `found` gets one entry for each pair, with pair −1 and depth 0 where nothing is inside.
  void eachPair(std::span<const std::span<const Vec3>> positions, std::span<const double> allowed, std::vector<Penetration>& found);

 private:
  struct Work;
  std::unique_ptr<Work> m_work;
};

/// The same for one state; builds its trees anew, so prefer PenetrationCheck inside a run.
Penetration deepestPenetration(std::span<const std::shared_ptr<const CollisionSurface>> surfaces,
                               std::span<const CollisionPair> pairs,
                               std::span<const std::span<const Vec3>> positions);

/// Triangles {of A, of B} that intersect or touch, of one pair, ascending; skipped triangles are left out. Of a surface with
/// itself: those that share no vertex, each two once.
/// Exact (spatial/Intersect). For `joint check`, not for a step.
struct PairIntersections {
  int pair = 0;
  std::vector<std::array<int, 2>> triangles;  ///< never empty
};
std::vector<PairIntersections> startIntersections(
    std::span<const std::shared_ptr<const CollisionSurface>> surfaces, std::span<const CollisionPair> pairs,
    std::span<const std::span<const Vec3>> positions);

}  // namespace glenoid
