// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/collide/FeatureOwners.h"
#include "simcore/collide/MovingSurface.h"
#include "simcore/collide/ProximityFinder.h"

namespace glenoid {

/// The search of one pair of surfaces, see README.md. Scratch is shared by all pairs of a finder; the result
/// is appended to. Used by ProximityFinder only.
class PairSearch {
 public:
  explicit PairSearch(const ProximityLimits& limits) : m_limits(limits) {}

  struct Settings {
    int pair = 0, motionCount = 0;
    double contactDistance = 0, dt = 0;
  };
  void run(const Settings& settings, MovingSurface& a, const FeatureOwners& ownersA, MovingSurface& b,
           const FeatureOwners& ownersB, std::vector<Proximity>& out, ProximityFinder::Counts& counts);

 private:
  /// Distances below this are taken as touching: the direction between two points says nothing any more. m.
  static constexpr double kTouching = 1e-9;

  /// One of the two surfaces, with marks for each of its vertices; a mark holds while it equals m_mark.
  struct Side {
    MovingSurface* surface = nullptr;
    const FeatureOwners* owners = nullptr;
    std::vector<long> chainMark, queueMark;
    std::vector<int> chain;  ///< first result of this vertex; results of a vertex are linked by m_next
    std::vector<int> queue;  ///< vertices that may be inside the other surface
  };

  void prepare(Side& side, MovingSurface& surface, const FeatureOwners& owners);
  void trianglePair(int ta, int tb);
  void vertexNearTriangle(Side& mine, Side& other, int vertex, int triangle);
  void acrossValleys(Side& mine, Side& other, int vertex, int triangle);
  void emitPlane(Side& mine, Side& other, int vertex, int triangle, double sine);
  void edgeNearEdge(int ea, int eb);
  void suspect(Side& mine, int vertex);
  void followInside(Side& mine, Side& other);
  bool inDepth(Side& side, const Vec3& p, double depth);
  bool nearestLocally(const MovingSurface& surface, const MovingSurface::Feature& feature, const Vec3& foot,
                      const Vec3& away) const;
  void emitVertex(Side& mine, Side& other, int vertex, int triangle, const Vec3& barycentric,
                  const MovingSurface::Feature& feature, const Vec3& outward, double gap);
  /// Whether points a of `first` and b of `second`, gap apart along the normal, come near in one of the motions.
  bool near(double gap, const Vec3& normal, const MovingSurface& first, const FeaturePoint& a, const MovingSurface& second,
            const FeaturePoint& b) const;

  ProximityLimits m_limits;
  Settings m_settings;
  Side m_a, m_b;
  std::vector<int> m_next;
  long m_mark = 0;
  std::vector<Proximity>* m_out = nullptr;
  ProximityFinder::Counts* m_counts = nullptr;
};

}  // namespace glenoid
