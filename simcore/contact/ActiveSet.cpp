// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/contact/ActiveSet.h"

#include <algorithm>
#include <cmath>

namespace glenoid {

namespace {

enum : char { kZero, kFree, kDependent };

/// What of a row's unit diagonal must be its own, beyond those taken in: below it the row depends on them.
constexpr double kOwn = 1e-11;

/// L of L Lᵀ = W over work.active[0 … count), with the row i after them; false where it depends on them.
bool append(LcpWork& work, int count, int i) {
  auto& L = work.factor;
  double own = work.scaled(i, i);
  for (int j = 0; j < count; ++j) {
    double sum = work.scaled(work.active[j], i);
    for (int k = 0; k < j; ++k) sum -= L(k, j) * L(k, count);  // kept transposed: columns are contiguous
    L(j, count) = sum / L(j, j);
    own -= L(j, count) * L(j, count);
  }
  if (!(own > kOwn)) return false;
  L(count, count) = std::sqrt(own);
  work.active[count] = i;
  return true;
}

/// The same without the one at `place`, by rotations.
void erase(LcpWork& work, int count, int place) {
  auto& L = work.factor;
  for (int j = place; j + 1 < count; ++j) {
    work.active[j] = work.active[j + 1];
    for (int k = 0; k <= j + 1; ++k) L(k, j) = L(k, j + 1);
    for (int k = place; k < j; ++k) {
      // Rotations of the columns before apply to this one.
      const double c = work.cosine[k], s = work.sine[k], upper = L(k, j), lower = L(k + 1, j);
      L(k, j) = c * upper + s * lower;
      L(k + 1, j) = c * lower - s * upper;
    }
    const double upper = L(j, j), lower = L(j + 1, j), length = std::sqrt(upper * upper + lower * lower);
    work.cosine[j] = upper / length;
    work.sine[j] = lower / length;
    L(j, j) = length;
  }
}

/// work.rhs = −W⁻¹ d over the rows taken in.
void solve(LcpWork& work, int count) {
  const auto& L = work.factor;
  auto& x = work.rhs;
  for (int j = 0; j < count; ++j) {
    double sum = -work.d[work.active[j]];
    for (int k = 0; k < j; ++k) sum -= L(k, j) * x[k];
    x[j] = sum / L(j, j);
  }
  for (int j = count - 1; j >= 0; --j) {
    x[j] /= L(j, j);
    for (int k = 0; k < j; ++k) x[k] -= L(k, j) * x[j];
  }
}

/// Makes room for the row i, which depends on those taken in: along the one change that moves nothing, as far as the first of them that
/// would pull, which leaves. False: none would, so the rows contradict each other.
bool exchange(LcpWork& work, int& count, int i) {
  auto& p = work.rhs;
  for (int j = 0; j < count; ++j) p[j] = -work.factor(j, count);  // of the append that failed
  for (int j = count - 1; j >= 0; --j) {
    p[j] /= work.factor(j, j);
    for (int k = 0; k < j; ++k) p[k] -= work.factor(k, j) * p[j];
  }
  int first = -1;
  double reach = 0;
  for (int j = 0; j < count; ++j) {
    if (!(p[j] < 0)) continue;
    const double far = work.lambda[work.active[j]] / -p[j];
    if (first >= 0 && far >= reach) continue;
    reach = far;
    first = j;
  }
  if (first < 0) return false;
  for (int j = 0; j < count; ++j) {
    double& at = work.lambda[work.active[j]];
    at = std::max(0.0, at + reach * p[j]);
  }
  work.lambda[i] += reach;
  work.lambda[work.active[first]] = 0;
  work.isActive[work.active[first]] = kZero;
  erase(work, count--, first);
  return true;
}

}  // namespace

bool activeSet(LcpWork& work, int n, double tolerance, int most, int& steps) {
  int count = 0;
  for (int i = 0; i < n; ++i) work.isActive[i] = kZero;
  work.lambda.head(n).setZero();
  work.w.head(n) = work.d.head(n);
  for (int step = 0; step < most; ++step, ++steps) {
    int newest = -1;
    bool leftOut = false;
    for (int i = 0; i < n; ++i) {
      if (work.isActive[i] == kDependent) leftOut = leftOut || work.w[i] < -tolerance;
      if (work.isActive[i] == kZero && work.w[i] < -tolerance && (newest < 0 || work.w[i] < work.w[newest])) newest = i;
    }
    if (newest < 0) return !leftOut;
    bool room = true;
    while (room && !append(work, count, newest)) room = exchange(work, count, newest);
    if (!room) {
      if (work.lambda[newest] > 0) return false;
      work.isActive[newest] = kDependent;
      continue;
    }
    ++count;
    work.isActive[newest] = kFree;
    for (bool whole = false; !whole && count > 0;) {
      solve(work, count);
      if (!work.rhs.head(count).allFinite()) return false;
      double reach = 1;  // how far towards the answer on these rows before one of them would pull
      int first = -1;
      for (int j = 0; j < count; ++j) {
        const double from = work.lambda[work.active[j]], to = work.rhs[j];
        if (to >= 0 || from > reach * (from - to)) continue;
        reach = from / (from - to);
        first = j;
      }
      whole = first < 0;
      for (int j = 0; j < count; ++j) {
        double& at = work.lambda[work.active[j]];
        at = whole ? work.rhs[j] : std::max(0.0, at + reach * (work.rhs[j] - at));
      }
      if (whole) break;
      const int leaves = work.active[first];
      work.lambda[leaves] = 0;
      // A row that leaves as it comes would come for ever.
      work.isActive[leaves] = leaves == newest ? kDependent : kZero;
      erase(work, count--, first);
    }
    work.w.head(n) = work.d.head(n);
    for (int j = 0; j < count; ++j) work.w.head(n) += work.lambda[work.active[j]] * work.scaled.col(work.active[j]).head(n);
  }
  return false;
}

}  // namespace glenoid
