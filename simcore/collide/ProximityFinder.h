// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <span>
#include <vector>

#include "simcore/collide/CollisionSurface.h"

namespace glenoid {

/// What bounds the search, in shares of the surfaces' own thickness (CollisionSurface), so that a scene of any size is
/// searched alike.
struct ProximityLimits {
  double depth = 1;        ///< of the surface that a vertex is inside: deeper it gives no constraint
  double edgeDepth = 0.5;  ///< of the thinner surface: the same for two edges that have passed each other
  double together = 0.5;   ///< of the thinner surface: an overlap so long is undone along one way if nearest ways contradict; infinite: never
};

/// Normal of a contact in the last step, by key: what decides between equal directions.
struct LastNormal {
  std::uint64_t key = 0;
  Vec3 normal_W = Vec3::UnitY();
};

/// Finds the feature pairs of two surfaces, or of one with itself, that are near or inside each other: the contact constraints of one
/// step. Stateless between calls except for scratch, so equal input gives equal results, whatever came
/// before. A pair may be a surface with itself (CollisionPair::self). README.md of this folder has the mathematics.
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
  /// look-ahead = max(0, −normal · (v_a − v_b)) dt, at most twice the sizes of both surfaces. `last` ascends by key.
  /// Valid until the next call.
  const std::vector<Proximity>& find(std::span<const std::span<const Vec3>> positions,
                                     std::span<const std::span<const Vec3>> velocities,
                                     double contactDistance, double dt, std::span<const LastNormal> last = {});

  /// Velocities of all surfaces as they may be in this step, laid out like find()'s.
  using Motion = std::span<const std::span<const Vec3>>;
  /// The same for several motions, at most kMotionsMost: what may come near, each surface following any of them.
  const std::vector<Proximity>& findAlong(std::span<const std::span<const Vec3>> positions,
                                          std::span<const Motion> motions, double contactDistance, double dt,
                                          std::span<const LastNormal> last = {});
  static constexpr int kMotionsMost = 8;

  const std::vector<CollisionPair>& pairs() const;
  const std::vector<std::shared_ptr<const CollisionSurface>>& surfaces() const;

  /// What the last call looked at, for tuning and reports.
  struct Counts {
    long trianglePairs = 0;             ///< whose boxes overlapped
    long vertexFace = 0, edgeEdge = 0;  ///< exact tests made
    long depthQueries = 0;              ///< nearest-point searches for what seemed to be inside
    long deepOverlaps = 0;              ///< undone along one direction for the whole (PairDeep.cpp)
    double selfMs = 0;                  ///< thread CPU time of surfaces with themselves
  };
  const Counts& counts() const;

 private:
  struct Work;
  std::unique_ptr<Work> m_work;
};

}  // namespace glenoid
