// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/collide/NormalCone.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace glenoid {
namespace {

/// Squared length below which a cross product of unit vectors gives no direction.
constexpr double kParallel = 1e-8;
/// Rounding of sines of unit vectors.
constexpr double kRounding = 1e-12;

/// A set of candidate normals is walked more than once and never kept: visit(n) for each corner that the common part of
/// two cones can have.
template <class Visit>
void eachCorner(const NormalCone& cone, const NormalCone& against, Visit&& visit) {
  for (const Vec3& n : cone.normals) visit(n);
  for (const Vec3& n : against.normals) visit(Vec3(-n));
  // Where a side of one cone crosses a side of the other: at right angles to a way of each.
  for (const Vec3& a : cone.ways)
    for (const Vec3& b : against.ways) {
      const Vec3 across = a.cross(b);
      const double size = across.squaredNorm();
      if (size < kParallel) continue;
      const Vec3 n = across / std::sqrt(size);
      visit(n);
      visit(Vec3(-n));
    }
}

/// The unit vector in the plane of two others, between them, that is nearest to `last`.
Vec3 nearestBetween(const Vec3& a, const Vec3& b, const Vec3& last) {
  const Vec3 axis = a.cross(b);
  const double size = axis.squaredNorm();
  if (size >= kParallel) {
    const Vec3 flat = last - last.dot(axis) / size * axis;
    if (a.cross(flat).dot(axis) > 0 && flat.cross(b).dot(axis) > 0) return flat.normalized();
  }
  return a.dot(last) > b.dot(last) ? a : b;
}

}  // namespace

void NormalCone::take(MovingSurface& surface, const MovingSurface::Feature& feature, const FeatureOwners& owners) {
  const CollisionSurface& s = surface.topology();
  normals.clear();
  ways.clear();
  const auto addNormal = [&](int triangle) {
    if (!owners.skipped(triangle) && surface.hasFace(triangle)) normals.push_back(surface.faceNormal(triangle));
  };
  const auto addWay = [&](const Vec3& way) {
    const double length = way.norm();
    if (length > 0) ways.push_back(way / length);
  };
  addWay(-surface.normalOf(feature));
  switch (feature.kind) {
    case FeatureKind::Face: {
      addNormal(feature.id);
      const auto& corners = s.triangles[feature.id];
      for (int k = 0; k < 3; ++k) {
        const Vec3 side = surface.x(corners[(k + 1) % 3]) - surface.x(corners[k]);
        addWay(side);
        addWay(-side);
      }
      return;
    }
    case FeatureKind::Edge: {
      const CollisionSurface::Edge& edge = s.edges[feature.id];
      const Vec3& on = surface.x(edge.vertices[0]);
      const Vec3 along = surface.x(edge.vertices[1]) - on;
      addWay(along);
      addWay(-along);
      for (int k = 0; k < 2; ++k) {
        if (edge.triangles[k] < 0 || owners.skipped(edge.triangles[k])) continue;
        addNormal(edge.triangles[k]);
        const Vec3 across = surface.x(edge.opposite[k]) - on;
        addWay(across - across.dot(along) / along.squaredNorm() * along);
      }
      return;
    }
    case FeatureKind::Vertex:
      for (const int t : s.trianglesOf(feature.id)) addNormal(t);
      for (const int e : s.edgesOf(feature.id)) {
        if (!owners.edgeTakesPart[e]) continue;
        const auto& ends = s.edges[e].vertices;
        addWay(surface.x(ends[0] == feature.id ? ends[1] : ends[0]) - surface.x(feature.id));
      }
      return;
  }
}

double NormalCone::beyond(const Vec3& normal) const {
  double most = -1;
  for (const Vec3& way : ways) most = std::max(most, normal.dot(way));
  return most;
}

std::optional<Vec3> sharedNormal(const NormalCone& cone, const NormalCone& against, double widened, double overlapMost,
                                 const Vec3* last) {
  const auto leaves = [&](const Vec3& n) { return std::max(0.0, cone.beyond(n)) + std::max(0.0, against.beyond(-n)); };
  if (last && leaves(*last) <= kRounding) return *last;

  // Corners that both allow exactly go before those that only the widened cones do.
  constexpr int kMost = 32;
  std::array<Vec3, kMost> corners;
  for (const double allowance : {kRounding, widened}) {
    int count = 0;
    eachCorner(cone, against, [&](const Vec3& n) {
      if (count == kMost || cone.beyond(n) > allowance || against.beyond(-n) > allowance) return;
      for (int i = 0; i < count; ++i)  // found again from the other cone, or where several sides cross
        if ((n - corners[i]).squaredNorm() < kParallel) return;
      corners[count++] = n;
    });
    if (count == 0) continue;
    Vec3 sum = Vec3::Zero(), nearest = corners[0];
    for (int i = 0; i < count; ++i) {
      sum += corners[i];
      for (int j = 0; last && j <= i; ++j)
        if (const Vec3 n = nearestBetween(corners[i], corners[j], *last); n.dot(*last) > nearest.dot(*last)) nearest = n;
    }
    if (last) return nearest;
    return sum.squaredNorm() > kParallel ? sum.normalized() : corners[0];
  }

  double least = overlapMost;
  std::optional<Vec3> best;
  eachCorner(cone, against, [&](const Vec3& n) {
    const double out = leaves(n);
    if (out >= least) return;
    least = out;
    best = n;
  });
  return best;
}

}  // namespace glenoid
