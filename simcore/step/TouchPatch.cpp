// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/step/TouchPatch.h"

#include <cmath>
#include <numbers>

#include "simcore/base/PlainMath.h"

namespace glenoid {

namespace {

/// Radius of the ring of six points, in shares of the patch's: with kTouchWeights the second and fourth moments of Hertz' pressure.
constexpr double kRing = 0.7559289460184544;  // √(4/7)

MaterialPoint pointOf(const SceneObject& object, int triangle, const Vec3& barycentric) {
  const auto& corners = object.collision.mesh->triangles[static_cast<std::size_t>(triangle)];
  const std::array<double, 3> weights{barycentric[0], barycentric[1], barycentric[2]};
  return pointAt(object.collision, false, corners, weights);
}
MaterialPoint pointOf(const SceneObject& object, const TriangleTree::Closest& closest) { return pointOf(object, closest.triangle, closest.barycentric); }

}  // namespace

Vec3 placeOf(const SceneObject& object, const MaterialPoint& point, const VecX& q) {
  Vec3 p = Vec3::Zero();
  for (int i = 0; i < point.count; ++i) p += point.weight[static_cast<std::size_t>(i)] * q.segment<3>(object.layout.qOffset + 3 * point.node[static_cast<std::size_t>(i)]);
  return p;
}

TouchPatch makeTouchPatch(const DentModel& dent, const SceneObject& object, const Vec3& near, double radius, const VecX& q) {
  TouchPatch patch;
  const TriangleTree::Closest middle = dent.surface->closest(near);
  const auto& corners = dent.surface->mesh().triangles[static_cast<std::size_t>(middle.triangle)];
  const auto corner = [&](int k) -> const Vec3& { return dent.surface->mesh().vertices[static_cast<std::size_t>(corners[static_cast<std::size_t>(k)])]; };
  const Vec3 facing = (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
  patch.middle = middle.point;
  patch.tissue = dent.tissue[static_cast<std::size_t>(middle.triangle)];
  patch.middlePoint = pointOf(object, middle);
  patch.e1 = facing.unitOrthogonal();
  patch.e2 = facing.cross(patch.e1);
  std::array<Vec3, 2> restSlopes{Vec3::Zero(), Vec3::Zero()};
  patch.slopes = restSlopes;
  const double ring = kRing * radius, squares = 3 * kTouchWeights[1] * ring * ring;  // Σ w u², and of w v²
  for (std::size_t k = 0; k < patch.points.size(); ++k) {
    const double angle = std::numbers::pi / 3 * static_cast<double>(k);
    const double u = k ? ring * plain::cosine(angle) : 0.0, v = k ? ring * plain::sine(angle) : 0.0;
    const TriangleTree::Closest at = k ? dent.surface->closest(middle.point + u * patch.e1 + v * patch.e2) : middle;
    patch.points[k] = pointOf(object, at);
    const Vec3 now = placeOf(object, patch.points[k], q);
    patch.rest += kTouchWeights[k] * at.point;
    patch.now += kTouchWeights[k] * now;
    patch.slopeWeights[0][k] = kTouchWeights[k] * u / squares;
    patch.slopeWeights[1][k] = kTouchWeights[k] * v / squares;
    for (std::size_t s = 0; s < 2; ++s) {
      restSlopes[s] += patch.slopeWeights[s][k] * at.point;
      patch.slopes[s] += patch.slopeWeights[s][k] * now;
    }
  }
  const Vec3 across = restSlopes[0].cross(restSlopes[1]);
  // On a rim the points may all lie on one line; then the triangle there has the only normal.
  if (const double area = across.norm(); area > 0.05) {
    patch.restNormal = across / area;
  } else {
    patch.restNormal = facing;
    patch.slopes = {patch.e1, patch.e2};
    patch.slopeWeights = {};
  }
  return patch;
}

double depthAt(const DentModel& dent, const Vec3& place, const Vec3& normal) {
  constexpr double kBelow = 1e-4;  // m: the place may lie a little beside the surface
  const auto hit = dent.surface->cast(dent.surface->closest(place).point - kBelow * normal, -normal);
  return hit ? kBelow + hit->distance : 0.0;
}

void findBack(const DentModel& dent, const SceneObject& object, TouchPatch& patch) {
  constexpr double kBelow = 1e-5;  // m
  const auto hit = dent.surface->cast(patch.middle - kBelow * patch.restNormal, -patch.restNormal);
  patch.hasBack = hit.has_value();
  if (hit) patch.back = pointOf(object, hit->triangle, hit->barycentric);
}

}  // namespace glenoid
