// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/simcore/coupling/Integrals.h"

#include <cmath>

namespace glenoid::test {

SurfaceIntegral integrated(const TriMesh& mesh, const std::vector<int>& triangles) {
  const double x[] = {0.5 - std::sqrt(0.15), 0.5, 0.5 + std::sqrt(0.15)}, w[] = {5.0 / 18, 8.0 / 18, 5.0 / 18};
  const auto each = [&](auto&& use) {
    for (const int index : triangles) {
      const auto& t = mesh.triangles[index];
      const Vec3 a = mesh.vertices[t[0]], b = mesh.vertices[t[1]], c = mesh.vertices[t[2]];
      const double jacobian = (b - a).cross(c - a).norm();
      for (int i = 0; i < 3; ++i)
        for (int j = 0; j < 3; ++j) {
          const double u = x[i], v = (1 - u) * x[j];
          use(w[i] * w[j] * (1 - u) * jacobian, Vec3(a + u * (b - a) + v * (c - a)));
        }
    }
  };
  SurfaceIntegral sum;
  each([&](double weight, const Vec3& p) {
    sum.area += weight;
    sum.centre += weight * p;
  });
  sum.centre /= sum.area;
  each([&](double weight, const Vec3& p) {
    const Vec3 r = p - sum.centre;
    sum.second += weight * r * r.transpose();
  });
  return sum;
}

double turning(const SurfaceIntegral& integral, const Vec3& n) {
  return integral.second.trace() - n.dot(integral.second * n);
}

}  // namespace glenoid::test
