// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/contact/Lcp.h"

#include <cmath>

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

/// Primal active set for the same problem as the minimum of ½ λᵀWλ + dᵀλ over λ ≥ 0: every point on the way is
/// feasible and lower than the last, so unlike pivoting it cannot cycle, however dependent the rows are. Rows that
/// round-off makes dependent on those taken in are left out. Slower than pivoting: one row in or out at a time.
/// From work.lambda ≥ 0. Source: Lawson and Hanson, "Solving Least Squares Problems", 1974, ch. 23 (NNLS).
bool activeSet(LcpWork& work, int n, int most, int& steps) {
  enum : char { kZero, kFree, kDependent };
  const double tolerance = toleranceOf(work, n);
  for (int i = 0; i < n; ++i) work.isActive[i] = work.lambda[i] > 0 ? kFree : kZero;
  int newest = -1;
  for (int step = 0; step < most; ++step, ++steps) {
    int count = 0;
    for (int i = 0; i < n; ++i)
      if (work.isActive[i] == kFree) work.active[count++] = i;
    if (!solveActive(work, count)) {
      int weakest = newest;  // the row that came last made the others dependent; at the start, the least loaded
      for (int j = 0; j < count && newest < 0; ++j)
        if (weakest < 0 || work.lambda[work.active[j]] < work.lambda[weakest]) weakest = work.active[j];
      if (weakest < 0) return false;
      work.isActive[weakest] = kDependent;
      work.lambda[weakest] = 0;
      newest = -1;
      continue;
    }
    double reach = 1;  // how far towards the answer on these rows before one of them would pull
    for (int j = 0; j < count; ++j) {
      const double from = work.lambda[work.active[j]], to = work.rhs[j];
      if (to < 0) reach = std::min(reach, from / (from - to));
    }
    for (int j = 0; j < count; ++j) {
      const int i = work.active[j];
      const double to = work.rhs[j], at = work.lambda[i] + reach * (to - work.lambda[i]);
      if (to < 0 && at <= 1e-15 * std::abs(to)) {
        work.isActive[i] = i == newest ? kDependent : kZero;  // a row that leaves as it comes would come for ever
        work.lambda[i] = 0;
      } else {
        work.lambda[i] = std::max(0.0, at);
      }
    }
    if (reach < 1) continue;
    work.w.head(n) = work.d.head(n);
    for (int j = 0; j < count; ++j) work.w.head(n) += work.lambda[work.active[j]] * work.scaled.col(work.active[j]).head(n);
    newest = -1;
    bool leftOut = false;
    for (int i = 0; i < n; ++i) {
      if (work.isActive[i] == kDependent) leftOut = leftOut || work.w[i] < -tolerance;
      if (work.isActive[i] == kZero && work.w[i] < -tolerance && (newest < 0 || work.w[i] < work.w[newest])) newest = i;
    }
    if (newest < 0) return !leftOut;
    work.isActive[newest] = kFree;
  }
  return false;
}

/// Block principal pivoting from the active set of work.lambda. True: work.lambda is exact.
bool pivot(LcpWork& work, int n, int most, int& pivots) {
  constexpr int kPatience = 4;  // whole-set exchanges that may fail to improve before single ones
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
    for (VecX* vector : {&work.d, &work.lambda, &work.w, &work.scale, &work.best, &work.rhs}) vector->resize(room);
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
  if (limits.pivots > 0) report.exact = pivot(work, n, limits.pivots, report.pivots);
  if (!report.exact && limits.pivots > 0) {
    work.lambda.head(n) = work.best.head(n);
    report.exact = activeSet(work, n, limits.activeSetSteps + 3 * n, report.pivots);
    if (!report.exact)
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
