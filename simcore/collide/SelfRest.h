// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <algorithm>
#include <memory>
#include <vector>

#include "simcore/collide/CollisionSurface.h"

namespace glenoid {

/// What a surface that may touch itself knows of its rest shape: how far two of its features lay apart, and whether air or
/// body lay between them. A point of a surface always has its own surface at distance zero and the far side of its own body
/// behind it; what is told here is which of that has come near since. Constant. Frames: the surface's rest frame, m.
class SelfRest {
 public:
  SelfRest(std::shared_ptr<const CollisionSurface> surface, std::vector<int> cellOfVertex);

  struct Apart {
    double distance = 0;  ///< m, at rest, straight
    bool facing = false;  ///< each lay in front of the other: air was between them
  };
  Apart vertexAndTriangle(int vertex, int triangle) const;
  Apart edges(int ea, int eb) const;
  /// A point on an edge, as a share t of the way from its first vertex, and a triangle.
  Apart edgePointAndTriangle(int edge, double t, int triangle) const;

  /// Whether a feature that lies `depth` behind another has come there from outside. What faced each other over air has.
  /// Else body lay between them, which is still there unless they are much nearer now than at rest.
  static bool cameFromOutside(const Apart& apart, double depth) { return apart.facing || depth < kNearer * apart.distance; }

  /// The contact distance of two features: not more than what they have at rest, so that rest makes no contact.
  static double contactDistance(double distance, const Apart& apart) {
    return std::min(distance, (1 - kRounding) * apart.distance);
  }

  /// Whether a triangle is so far from a point that `depth` says at once: it has not come from outside. A bound that costs a
  /// tenth; where it does not hold, the exact answer does.
  bool farAndBehind(int vertex, int triangle, double depth) const {
    const Vec3 way = m_centre[triangle] - m_surface->restVertices[vertex];
    return m_vertexNormal[vertex].dot(way) < -m_radius[triangle] && depth >= kNearer * (way.norm() + m_radius[triangle]);
  }

  /// Triangles that cross each other as the surface was made, and go on doing so.
  bool crossAtRest(int ta, int tb) const {
    return std::binary_search(m_crossing.begin(), m_crossing.end(), std::array<int, 2>{std::min(ta, tb), std::max(ta, tb)});
  }

  bool share(int vertex, int triangle) const {
    const auto& c = m_surface->triangles[triangle];
    return c[0] == vertex || c[1] == vertex || c[2] == vertex;
  }
  bool trianglesShare(int ta, int tb) const {
    const auto& c = m_surface->triangles[ta];
    return share(c[0], tb) || share(c[1], tb) || share(c[2], tb);
  }
  bool edgesShare(int ea, int eb) const;
  /// Whether one cell drives both points.
  bool sameCell(const FeaturePoint& a, const FeaturePoint& b) const;

 private:
  /// Tissue that is pressed to less than this share of what it was between its two sides would count as its two sides
  /// passing through each other; what has come through by more than this share of its way along the surface does not count.
  static constexpr double kNearer = 0.25;
  /// Cosine within which each has to see the other along its normal to face it.
  static constexpr double kFacing = 0.5;
  /// Share of a rest distance that rounding may take.
  static constexpr double kRounding = 1e-6;

  Apart apart(const Vec3& a, const Vec3& normalA, const Vec3& b, const Vec3& normalB) const;
  Vec3 edgeNormal(int edge) const;

  std::shared_ptr<const CollisionSurface> m_surface;
  std::vector<int> m_cellOfVertex;
  std::vector<Vec3> m_faceNormal, m_vertexNormal;  ///< unit, or zero
  std::vector<Vec3> m_centre;                      ///< of triangles, m
  std::vector<double> m_radius;                    ///< of the ball about it that holds the triangle, m
  std::vector<std::array<int, 2>> m_crossing;      ///< ascending
};

}  // namespace glenoid
