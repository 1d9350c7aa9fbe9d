// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/collide/MovingSurface.h"

/// Points of features as PairSearch makes them.
namespace glenoid {

inline FeaturePoint vertexPoint(int vertex) {
  FeaturePoint point;
  point.vertex = {vertex, vertex, vertex};
  return point;
}

inline FeaturePoint edgePoint(const CollisionSurface::Edge& edge, double t) {
  FeaturePoint point;
  point.count = 2;
  point.vertex = {edge.vertices[0], edge.vertices[1], edge.vertices[1]};
  point.weight = {1 - t, t, 0};
  return point;
}

/// The corners that carry the point, in the triangle's order.
inline FeaturePoint trianglePoint(const std::array<int, 3>& triangle, const Vec3& w) {
  FeaturePoint point;
  point.count = 0;
  for (int k = 0; k < 3; ++k) {
    if (!(w[k] > 0)) continue;
    point.vertex[point.count] = triangle[k];
    point.weight[point.count++] = w[k];
  }
  for (int k = point.count; k < 3; ++k) {
    point.vertex[k] = point.vertex[point.count - 1];
    point.weight[k] = 0;
  }
  return point;
}

inline Vec3 velocityOf(const MovingSurface& surface, int motion, const FeaturePoint& point) {
  Vec3 v = Vec3::Zero();
  for (int k = 0; k < point.count; ++k) v += point.weight[k] * surface.v(motion, point.vertex[k]);
  return v;
}

}  // namespace glenoid
