// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/coupling/AreaMoments.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>

namespace glenoid {

namespace {
double areaOfTriangle(const Triangle& t) { return (t[1] - t[0]).cross(t[2] - t[0]).norm() / 2; }
}  // namespace

AreaMoments momentsOf(std::span<const Triangle> triangles) {
  AreaMoments moments;
  if (triangles.empty()) return moments;
  const Vec3 near = triangles[0][0];
  Vec3 first = Vec3::Zero();
  for (const Triangle& t : triangles) {
    const double area = areaOfTriangle(t);
    moments.area += area;
    first += area / 3 * ((t[0] - near) + (t[1] - near) + (t[2] - near));
  }
  if (!(moments.area > 0)) return AreaMoments{};
  moments.centre = near + first / moments.area;
  // ∫ x xᵀ dA = A/12 (Σ xᵢ xᵢᵀ + (Σ xᵢ)(Σ xᵢ)ᵀ) over a triangle, with x from the common centre.
  for (const Triangle& t : triangles) {
    const Vec3 a = t[0] - moments.centre, b = t[1] - moments.centre, c = t[2] - moments.centre, sum = a + b + c;
    moments.second += areaOfTriangle(t) / 12 *
                      (a * a.transpose() + b * b.transpose() + c * c.transpose() + sum * sum.transpose());
  }
  return moments;
}

Vec3 radiiOfGyration(const AreaMoments& moments) {
  if (!(moments.area > 0)) return Vec3::Zero();
  const Mat3 spread = moments.second / moments.area;
  return Eigen::SelfAdjointEigenSolver<Mat3>(spread, Eigen::EigenvaluesOnly).eigenvalues().cwiseMax(0).cwiseSqrt();
}

std::array<Vec3, 4> pointsWithMoments(const AreaMoments& moments) {
  Mat3 L = Mat3::Zero();
  if (moments.area > 0) {
    // Written out, since a plane piece has a singular S: a pivot of round-off is a direction without extent.
    const Mat3 spread = moments.second / moments.area;
    const double none = 1e-14 * spread.trace();
    for (int c = 0; c < 3; ++c) {
      const double pivot = spread(c, c) - L.row(c).head(c).squaredNorm();
      if (!(pivot > none)) continue;
      L(c, c) = std::sqrt(pivot);
      for (int r = c + 1; r < 3; ++r) L(r, c) = (spread(r, c) - L.row(r).head(c).dot(L.row(c).head(c))) / L(c, c);
    }
  }
  const Vec3 corners[] = {{1, 1, 1}, {1, -1, -1}, {-1, 1, -1}, {-1, -1, 1}};
  std::array<Vec3, 4> points;
  for (int i = 0; i < 4; ++i) points[i] = moments.centre + L * corners[i];
  return points;
}

std::array<std::vector<Triangle>, 2> cutAt(std::span<const Triangle> triangles, int axis, double at) {
  std::array<std::vector<Triangle>, 2> sides;
  for (const Triangle& t : triangles) {
    std::array<std::array<Vec3, 4>, 2> corners;  // a cut triangle leaves three corners on one side and four on the other
    std::array<int, 2> count{};
    for (int i = 0; i < 3; ++i) {
      const Vec3 &p = t[i], &q = t[(i + 1) % 3];
      const double from = p[axis] - at, to = q[axis] - at;
      if (from <= 0) corners[0][count[0]++] = p;
      if (from >= 0) corners[1][count[1]++] = p;
      if (from * to < 0) {
        const Vec3 between = p + from / (from - to) * (q - p);
        corners[0][count[0]++] = between;
        corners[1][count[1]++] = between;
      }
    }
    for (int side = 0; side < 2; ++side)
      for (int i = 2; i < count[side]; ++i) {
        const Triangle piece{corners[side][0], corners[side][i - 1], corners[side][i]};
        if (areaOfTriangle(piece) > 0) sides[side].push_back(piece);
      }
  }
  return sides;
}

}  // namespace glenoid
