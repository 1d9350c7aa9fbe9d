// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/linear/ConjugateGradients.h"

#include <Eigen/LU>
#include <cassert>
#include <cmath>
#include <limits>

namespace glenoid {
namespace {

void applyBlocks(const std::vector<Mat3>& blocks, const VecX& x, VecX& y) {
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const auto at = 3 * static_cast<Eigen::Index>(i);
    y.segment<3>(at).noalias() = blocks[i] * x.segment<3>(at);
  }
}

}  // namespace

CgReport solveConjugateGradients(const BlockMatrix& A, const VecX& b, VecX& x, const CgLimits& limits,
                                 CgWork& work, bool blockJacobi) {
  const int n = A.symbolic().blockCount();
  assert(b.size() == 3 * n);
  const bool guess = x.size() == b.size();
  work.x.resize(b.size());
  work.z.resize(b.size());
  work.p.resize(b.size());
  if (guess) {
    work.x = x;
    A.multiply(work.x, work.q);
    work.r = b - work.q;
  } else {
    work.x.setZero();
    work.r = b;
  }
  if (blockJacobi) {
    work.inverseDiagonal.resize(static_cast<std::size_t>(n));
    for (int i = 0; i < n; ++i) work.inverseDiagonal[static_cast<std::size_t>(i)] = A.block(i, i).inverse();
  }
  const auto precondition = [&]() -> const VecX& {
    if (!blockJacobi) return work.r;
    applyBlocks(work.inverseDiagonal, work.r, work.z);
    return work.z;
  };

  const double norm = b.norm();
  const double scale = norm > 0.0 ? norm : 1.0;
  CgReport report{0, work.r.norm() / scale, false, true};
  if (std::isfinite(report.residual) && report.residual > limits.tolerance) {
    const VecX& first = precondition();
    work.p = first;
    double rho = work.r.dot(first);
    while (report.residual > limits.tolerance) {
      if (report.iterations >= limits.iterations) {
        report.capped = true;
        break;
      }
      A.multiply(work.p, work.q);
      const double curvature = work.p.dot(work.q);
      if (!(curvature > 0.0) || !(rho > 0.0)) {  // also catches NaN
        report.finite = false;
        break;
      }
      const double alpha = rho / curvature;
      work.x += alpha * work.p;
      work.r -= alpha * work.q;
      const VecX& z = precondition();
      const double next = work.r.dot(z);
      work.p = z + (next / rho) * work.p;
      rho = next;
      ++report.iterations;
      report.residual = (blockJacobi ? work.r.norm() : std::sqrt(rho)) / scale;
    }
  }
  report.finite = report.finite && std::isfinite(report.residual) && work.x.allFinite();
  if (report.finite) x = work.x;
  return report;
}

double estimateLambdaMax(const BlockMatrix& A, const std::function<void(VecX&)>& applyDinv, int iterations,
                         PowerWork& work) {
  const Eigen::Index size = 3 * static_cast<Eigen::Index>(A.symbolic().blockCount());
  if (size == 0) return 0.0;
  // A fixed start without symmetry, so that it is orthogonal to no eigenvector that structure would give:
  // the golden-ratio sequence, centred.
  work.x.resize(size);
  work.z.resize(size);
  double fraction = 0.0;
  for (Eigen::Index i = 0; i < size; ++i) {
    fraction += 0.6180339887498949;
    if (fraction >= 1.0) fraction -= 1.0;
    work.x[i] = fraction - 0.5;
  }
  double lambda = 0.0;
  for (int i = 0; i < iterations; ++i) {
    A.multiply(work.x, work.y);
    work.z = work.y;
    applyDinv(work.z);
    const double energy = work.x.dot(work.y);
    const double norm = work.z.norm();
    if (energy == 0.0 || norm == 0.0) return 0.0;
    lambda = work.z.dot(work.y) / energy;
    if (!std::isfinite(lambda) || !std::isfinite(norm)) return std::numeric_limits<double>::quiet_NaN();
    work.x = work.z / norm;
  }
  return lambda;
}

double estimateLambdaMax(const BlockMatrix& A, const std::function<void(VecX&)>& applyDinv, int iterations,
                         VecX& work) {
  PowerWork own;
  const double lambda = estimateLambdaMax(A, applyDinv, iterations, own);
  work = own.x;
  return lambda;
}

}  // namespace glenoid
