// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "simcore/collide/CollisionSurface.h"

namespace glenoid {

/// Lengths that bound the search, m. The defaults suit a joint in metres.
struct ProximityLimits {
  double depth = 4e-3;      ///< a vertex deeper inside than this gives no constraint
  double edgeDepth = 2e-3;  ///< the same for two edges that have passed each other
  double lookAhead = 2e-3;  ///< most that closing speed × dt adds to the contact distance
};

/// Finds the feature pairs of two surfaces that are near or inside each other: the contact constraints of one
/// step. Stateless between calls except for scratch, so equal positions give equal results, whatever came
/// before. Wrong to use for a surface against itself. README.md of this folder has the mathematics.
/// Frames: W. Units: m, m/s, s. Answers are sorted by key. Allocates nothing once the most contacts have been
/// seen. One thread at a time. Not-finite positions give no contact for the surfaces concerned.
class ProximityFinder {
 public:
  ProximityFinder(std::vector<std::shared_ptr<const CollisionSurface>> surfaces,
                  std::vector<CollisionPair> pairs, const ProximityLimits& limits = {});
  ~ProximityFinder();
  ProximityFinder(ProximityFinder&&) noexcept;
  ProximityFinder& operator=(ProximityFinder&&) noexcept;

  /// positions[s] and velocities[s] hold one entry for each vertex of surface s; `velocities`, or one of its
  /// entries, may be empty: at rest. A pair of features counts when gap < contactDistance + look-ahead, with
  /// look-ahead = min(limits.lookAhead, max(0, −normal · (v_a − v_b)) dt). Valid until the next call.
  const std::vector<Proximity>& find(std::span<const std::span<const Vec3>> positions,
                                     std::span<const std::span<const Vec3>> velocities,
                                     double contactDistance, double dt);

  /// Velocities of all surfaces as they may be in this step, laid out like find()'s.
  using Motion = std::span<const std::span<const Vec3>>;
  /// The same for several motions, at most kMotionsMost: what may come near, each surface following any of them.
  const std::vector<Proximity>& findAlong(std::span<const std::span<const Vec3>> positions,
                                          std::span<const Motion> motions, double contactDistance, double dt);
  static constexpr int kMotionsMost = 4;

  const std::vector<CollisionPair>& pairs() const;
  const std::vector<std::shared_ptr<const CollisionSurface>>& surfaces() const;

  /// What the last call looked at, for tuning and reports.
  struct Counts {
    long trianglePairs = 0;             ///< whose boxes overlapped
    long vertexFace = 0, edgeEdge = 0;  ///< exact tests made
    long depthQueries = 0;              ///< nearest-point searches for what seemed to be inside
  };
  const Counts& counts() const;

 private:
  struct Work;
  std::unique_ptr<Work> m_work;
};

}  // namespace glenoid
