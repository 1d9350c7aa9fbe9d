// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/contact/Lcp.h"

#include <algorithm>
#include <cmath>

#include "simcore/contact/ActiveSet.h"

namespace glenoid {

namespace {

/// In units in which W has a unit diagonal. One sweep over all rows, in order.
void sweep(const MatX& W, const VecX& d, VecX& lambda, int n) {
  for (int i = 0; i < n; ++i) {
    const double w = W.col(i).head(n).dot(lambda.head(n)) + d[i];
    lambda[i] = std::max(0.0, lambda[i] - w / W(i, i));
  }
}

/// Cholesky of the active rows and columns, W_FF λ_F = −d_F; false where it breaks down.
bool solveActive(LcpWork& work, int count) {
  for (int j = 0; j < count; ++j) {
    work.rhs[j] = -work.d[work.active[j]];
    for (int i = j; i < count; ++i) work.factor(i, j) = work.scaled(work.active[i], work.active[j]);
  }
  auto block = work.factor.topLeftCorner(count, count);
  Eigen::LLT<Eigen::Ref<MatX>, Eigen::Lower> llt(block);  // in place
  if (llt.info() != Eigen::Success) return false;
  auto rhs = work.rhs.head(count);
  llt.matrixL().solveInPlace(rhs);
  llt.matrixU().solveInPlace(rhs);
  return rhs.allFinite();
}

/// How far below zero a w may lie, in units of the scaled problem: round-off of its sum.
double toleranceOf(const LcpWork& work, int n) { return 1e-12 * (1e-3 + work.d.head(n).cwiseAbs().maxCoeff()); }

/// Block principal pivoting from the active set of work.lambda. True: work.lambda is exact.
bool pivot(LcpWork& work, int n, int most, int& pivots) {
  constexpr int kPatience = 4;  // whole-set exchanges that may fail to improve before single ones
  constexpr int kSingly = 60;   // rows up to which single ones, a factorization each, are worth a try
  int best = n + 1, patience = kPatience;
  const double tolerance = toleranceOf(work, n);
  for (int i = 0; i < n; ++i) work.isActive[i] = work.lambda[i] > 0;
  for (pivots = 0; pivots < most; ++pivots) {
    int count = 0;
    for (int i = 0; i < n; ++i)
      if (work.isActive[i]) work.active[count++] = i;
    if (!solveActive(work, count)) return false;
    work.w.head(n) = work.d.head(n);
    work.lambda.head(n).setZero();
    for (int j = 0; j < count; ++j) {
      work.lambda[work.active[j]] = work.rhs[j];
      work.w.head(n) += work.rhs[j] * work.scaled.col(work.active[j]).head(n);
    }
    int wrong = 0, last = -1;
    const auto isWrong = [&](int i) {
      return work.isActive[i] ? work.lambda[i] < 0 : work.w[i] < -tolerance;
    };
    for (int i = 0; i < n; ++i)
      if (isWrong(i)) ++wrong, last = i;
    if (wrong == 0) return true;
    if (wrong < best) {
      best = wrong;
      patience = kPatience;
    } else {
      --patience;
    }
    if (patience >= 0) {
      for (int i = 0; i < n; ++i)
        if (isWrong(i)) work.isActive[i] = !work.isActive[i];
    } else if (n > kSingly) {
      return false;
    } else {
      work.isActive[last] = !work.isActive[last];  // Murty's rule: finite, if slow
    }
  }
  return false;
}

}  // namespace

LcpReport solveLcp(const Eigen::Ref<const MatX>& W, const Eigen::Ref<const VecX>& d, Eigen::Ref<VecX> lambda,
                   const LcpLimits& limits, LcpWork& work) {
  LcpReport report;
  const int n = static_cast<int>(d.size());
  if (n == 0) {
    report.exact = true;
    return report;
  }
  if (work.scaled.rows() < n) {
    const int room = n + n / 2 + 8;
    work.scaled.resize(room, room);
    work.factor.resize(room, room);
    for (VecX* vector : {&work.d, &work.lambda, &work.w, &work.scale, &work.best, &work.rhs, &work.cosine, &work.sine}) vector->resize(room);
    work.active.resize(room);
    work.isActive.resize(room);
  }
  // Rows of bone and of fat differ by decades: with a unit diagonal one tolerance suits all.
  for (int i = 0; i < n; ++i) work.scale[i] = W(i, i) > 0 ? 1 / std::sqrt(W(i, i)) : 0;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) work.scaled(i, j) = work.scale[i] * W(i, j) * work.scale[j];
    work.scaled(j, j) = 1 + limits.compliance;
    work.d[j] = work.scale[j] * d[j];
    work.lambda[j] = work.scale[j] > 0 ? std::max(0.0, lambda[j] / work.scale[j]) : 0;
    if (!std::isfinite(work.lambda[j])) work.lambda[j] = 0;
  }
  for (; report.sweeps < limits.sweeps; ++report.sweeps) sweep(work.scaled, work.d, work.lambda, n);
  work.best.head(n) = work.lambda.head(n);
  if (limits.pivots > 0) report.exact = pivot(work, n, std::min(limits.pivots, limits.stepsMost), report.pivots);
  if (!report.exact && limits.pivots > 0) {
    report.exact = activeSet(work, n, toleranceOf(work, n), limits.activeSetSteps + 3 * n, report.rowSteps);
    if (!report.exact) work.lambda.head(n) = work.best.head(n);
    if (!report.exact && limits.sweepsLast)
      for (int i = 0; i < limits.lastSweeps; ++i, ++report.sweeps) sweep(work.scaled, work.d, work.lambda, n);
  }
  for (int i = 0; i < n; ++i) {
    const double w = work.scaled.col(i).head(n).dot(work.lambda.head(n)) + work.d[i];
    const double error = std::abs(std::min(work.lambda[i], w));
    if (work.scale[i] > 0) report.error = std::max(report.error, error / work.scale[i]);
    lambda[i] = work.lambda[i] * work.scale[i];
  }
  return report;
}

}  // namespace glenoid
