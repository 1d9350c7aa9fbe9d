// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/contact/KrylovSolve.h"

#include <array>
#include <cmath>

namespace glenoid {

void solveShifted(const std::function<void(const VecX& x, VecX& Tx)>& apply, int size, double tolerance, VecX& e,
                  KrylovWork& work) {
  constexpr int kMost = KrylovWork::kDirections;
  if (work.next.size() < size) {
    work.basis.resize(size + size / 2 + 8, kMost + 1);
    work.next.resize(size + size / 2 + 8);
  }
  const double start = e.head(size).norm();
  if (!(start > 0)) return;
  work.basis.col(0).head(size) = e.head(size) / start;
  Eigen::Matrix<double, kMost + 1, kMost> H = Eigen::Matrix<double, kMost + 1, kMost>::Zero();  // triangular after rotations
  std::array<double, kMost> cosine{}, sine{};
  Eigen::Matrix<double, kMost + 1, 1> rhs = Eigen::Matrix<double, kMost + 1, 1>::Zero();
  rhs[0] = start;
  int used = 0;
  while (used < kMost && std::abs(rhs[used]) > tolerance * start) {
    const int k = used;
    // The image of a direction; the product may use anything of `next`.
    VecX& image = work.next;
    e.head(size) = work.basis.col(k).head(size);
    apply(e, image);
    image.head(size) = e.head(size) - image.head(size);
    for (int j = 0; j <= k; ++j) {
      H(j, k) = work.basis.col(j).head(size).dot(image.head(size));
      image.head(size) -= H(j, k) * work.basis.col(j).head(size);
    }
    const double length = image.head(size).norm();
    for (int j = 0; j < k; ++j) {
      const double upper = cosine[j] * H(j, k) + sine[j] * H(j + 1, k);
      H(j + 1, k) = cosine[j] * H(j + 1, k) - sine[j] * H(j, k);
      H(j, k) = upper;
    }
    const double radius = std::sqrt(H(k, k) * H(k, k) + length * length);
    if (!(radius > 0)) break;
    cosine[k] = H(k, k) / radius;
    sine[k] = length / radius;
    H(k, k) = radius;
    rhs[k + 1] = -sine[k] * rhs[k];
    rhs[k] *= cosine[k];
    ++used;
    if (!(length > 1e-14 * radius)) break;
    work.basis.col(k + 1).head(size) = image.head(size) / length;
  }
  for (int k = used - 1; k >= 0; --k) {
    for (int j = k + 1; j < used; ++j) rhs[k] -= H(k, j) * rhs[j];
    rhs[k] /= H(k, k);
  }
  e.head(size).setZero();
  for (int k = 0; k < used; ++k) e.head(size) += rhs[k] * work.basis.col(k).head(size);
}

}  // namespace glenoid
