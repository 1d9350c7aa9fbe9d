// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/embed/BoxMoments.h"

namespace glenoid {

BoxMoments fullBox(double volume) {
  constexpr double kMean[3] = {1, 0, 1.0 / 3};
  BoxMoments moments;
  for (int k = 0; k < 27; ++k) moments.value[k] = volume * kMean[k % 3] * kMean[k / 3 % 3] * kMean[k / 9];
  return moments;
}

BoxMoments inOtherBox(const BoxMoments& moments, const CellBox& from, const CellBox& to) {
  // ξ' = s ξ + c along each axis.
  const Vec3 c = to.coordinatesOf(from.origin + 0.5 * from.axes * from.edges), s = from.edges.cwiseQuotient(to.edges);
  BoxMoments moved = moments;
  for (int axis = 0, stride = 1; axis < 3; ++axis, stride *= 3)
    for (int k = 0; k < 27; ++k) {
      if (k / stride % 3 != 0) continue;
      const double m0 = moved.value[k], m1 = moved.value[k + stride], m2 = moved.value[k + 2 * stride];
      moved.value[k + stride] = s[axis] * m1 + c[axis] * m0;
      moved.value[k + 2 * stride] = s[axis] * s[axis] * m2 + 2 * s[axis] * c[axis] * m1 + c[axis] * c[axis] * m0;
    }
  return moved;
}

Vec3 meanOf(const BoxMoments& m) { return Vec3(m.value[1], m.value[3], m.value[9]) / m.volume(); }

Vec3 varianceOf(const BoxMoments& m) {
  return (Vec3(m.value[2], m.value[6], m.value[18]) / m.volume() - meanOf(m).cwiseAbs2()).cwiseMax(0);
}

std::array<BoxPoint, 27> boxPoints(const BoxMoments& moments) {
  std::array<double, 27> w = moments.value;
  // Along one axis after the other: from (m0, m1, m2) to weights at −1, 0, 1.
  for (const int stride : {1, 3, 9})
    for (int k = 0; k < 27; ++k) {
      if (k / stride % 3 != 0) continue;
      const double m0 = w[k], m1 = w[k + stride], m2 = w[k + 2 * stride];
      w[k] = 0.5 * (m2 - m1);
      w[k + stride] = m0 - m2;
      w[k + 2 * stride] = 0.5 * (m2 + m1);
    }
  std::array<BoxPoint, 27> points;
  for (int k = 0; k < 27; ++k) points[k] = {{k % 3 - 1.0, k / 3 % 3 - 1.0, k / 9 - 1.0}, w[k]};
  return points;
}

}  // namespace glenoid
