// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/embed/MeanValue.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "simcore/base/PlainMath.h"

namespace glenoid {
namespace {

/// Barycentric coordinates by the areas of the angles: right for a point inside the triangle's plane region.
void setFlat(VecX& weights, const std::array<int, 3>& corners, const std::array<double, 3>& theta,
             const std::array<double, 3>& distance) {
  weights.setZero();
  for (int i = 0; i < 3; ++i) {
    const int next = (i + 1) % 3, last = (i + 2) % 3;
    weights[corners[i]] += plain::sine(theta[i]) * distance[next] * distance[last];
  }
}

}  // namespace

VecX meanValueCoordinates(const TriMesh& surface, const Vec3& p) {
  constexpr double kFlat = 1e-9;  // radians; below, sines lose their digits
  const std::size_t n = surface.vertices.size();
  const double size = boundsOf(surface).diagonal().norm();
  std::vector<Vec3> unit(n);
  std::vector<double> distance(n);
  VecX weights = VecX::Zero(static_cast<Eigen::Index>(n));
  for (std::size_t v = 0; v < n; ++v) {
    unit[v] = surface.vertices[v] - p;
    distance[v] = unit[v].norm();
    if (distance[v] <= 1e-12 * size) {
      weights[static_cast<Eigen::Index>(v)] = 1;
      return weights;
    }
    unit[v] /= distance[v];
  }
  for (const auto& t : surface.triangles) {
    std::array<double, 3> theta, sine;
    const std::array<double, 3> far{distance[t[0]], distance[t[1]], distance[t[2]]};
    for (int i = 0; i < 3; ++i) {
      const double chord = (unit[t[(i + 1) % 3]] - unit[t[(i + 2) % 3]]).norm();
      theta[i] = 2 * plain::arcSine(chord / 2);
    }
    const double h = (theta[0] + theta[1] + theta[2]) / 2;
    if (std::numbers::pi - h < kFlat) {  // the point lies in the triangle
      setFlat(weights, t, theta, far);
      return weights / weights.sum();
    }
    bool inPlane = false;
    const double turn = unit[t[0]].dot(unit[t[1]].cross(unit[t[2]]));
    std::array<double, 3> cosine;
    for (int i = 0; i < 3; ++i) {
      const int next = (i + 1) % 3, last = (i + 2) % 3;
      const double down = plain::sine(theta[next]) * plain::sine(theta[last]);
      if (!(down > 0)) {
        inPlane = true;
        break;
      }
      cosine[i] = 2 * plain::sine(h) * plain::sine(h - theta[i]) / down - 1;
      sine[i] = std::copysign(std::sqrt(std::max(0.0, 1 - cosine[i] * cosine[i])), turn);
      if (std::abs(sine[i]) <= kFlat) inPlane = true;
    }
    if (inPlane) continue;  // in its plane and outside it: it covers no angle
    for (int i = 0; i < 3; ++i) {
      const int next = (i + 1) % 3, last = (i + 2) % 3;
      weights[t[i]] += (theta[i] - cosine[next] * theta[last] - cosine[last] * theta[next]) /
                       (far[i] * plain::sine(theta[next]) * sine[last]);
    }
  }
  return weights / weights.sum();
}

}  // namespace glenoid
