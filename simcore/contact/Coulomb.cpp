// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/contact/Coulomb.h"

#include <algorithm>
#include <cmath>

namespace glenoid {

namespace {

using Vec2 = Eigen::Vector2d;

Vec2 onDisk(const Vec2& t, double radius) {
  const double length = t.norm();
  return length <= radius ? t : Vec2(radius / length * t);
}

/// Largest eigenvalue of the 2×2 block at (i, i).
double stiffest(const MatX& W, int i) {
  const double mean = 0.5 * (W(i, i) + W(i + 1, i + 1)), half = 0.5 * (W(i, i) - W(i + 1, i + 1));
  return mean + std::sqrt(half * half + W(i + 1, i) * W(i + 1, i));
}

/// One round over all contacts, in order: normal, then the tangential pair for the new normal impulse.
void sweep(CoulombWork& work, int n) {
  const MatX& W = work.scaled;
  auto lambda = work.lambda.head(n);
  for (const ContactUnknowns& contact : work.contacts) {
    const int i = contact.row;
    lambda[i] = std::max(0.0, lambda[i] - (W.col(i).head(n).dot(lambda) + work.d[i]) / W(i, i));
    if (!contact.tangential) continue;
    const Vec2 slip(W.col(i + 1).head(n).dot(lambda) + work.d[i + 1], W.col(i + 2).head(n).dot(lambda) + work.d[i + 2]);
    lambda.segment<2>(i + 1) =
        onDisk(lambda.segment<2>(i + 1) - slip / stiffest(W, i + 1), contact.friction * lambda[i]);
  }
}

/// w from lambda; then how far lambda is from its own projection, largest over all rows (scaled, and in m/s).
double natural(CoulombWork& work, int n, double* inMetres = nullptr) {
  work.w.head(n) = work.d.head(n);
  for (int i = 0; i < n; ++i)
    if (work.lambda[i] != 0) work.w.head(n) += work.lambda[i] * work.scaled.col(i).head(n);
  double worst = 0;
  const auto count = [&](double error, int row) {
    worst = std::max(worst, error);
    if (inMetres && work.scale[row] > 0) *inMetres = std::max(*inMetres, error / work.scale[row]);
  };
  for (const ContactUnknowns& contact : work.contacts) {
    const int i = contact.row;
    count(std::abs(std::min(work.lambda[i], work.w[i])), i);
    if (!contact.tangential) continue;
    const Vec2 t = work.lambda.segment<2>(i + 1);
    count((t - onDisk(t - work.w.segment<2>(i + 1), contact.friction * std::max(0.0, work.lambda[i]))).norm(), i + 1);
  }
  return worst;
}

/// x ← A⁻¹ x by elimination with partial pivoting, in place; false where A is singular. (Eigen's LU allocates.)
bool eliminate(MatX& A, VecX& x, int n) {
  for (int k = 0; k < n; ++k) {
    int pivot = k;
    for (int i = k + 1; i < n; ++i)
      if (std::abs(A(i, k)) > std::abs(A(pivot, k))) pivot = i;
    if (!(std::abs(A(pivot, k)) > 1e-14)) return false;  // entries are of the order of one
    if (pivot != k) {
      for (int j = k; j < n; ++j) std::swap(A(k, j), A(pivot, j));
      std::swap(x[k], x[pivot]);
    }
    const int rest = n - k - 1;
    auto below = A.col(k).segment(k + 1, rest);
    below /= A(k, k);
    for (int j = k + 1; j < n; ++j) A.col(j).segment(k + 1, rest) -= A(k, j) * below;
    x.segment(k + 1, rest) -= x[k] * below;
  }
  for (int k = n - 1; k >= 0; --k) {
    x[k] /= A(k, k);
    x.head(k) -= x[k] * A.col(k).head(k);
  }
  return x.head(n).allFinite();
}

/// One Newton step of the projected equations from (lambda, w) of natural(). Contacts that the projection opens
/// get zero; the others solve w_n = 0 with w_t = 0 (stick) or with λ_t on the edge of its disk (slip).
bool newtonStep(CoulombWork& work, int n) {
  work.unknowns.clear();
  for (const ContactUnknowns& contact : work.contacts)
    if (work.lambda[contact.row] - work.w[contact.row] > 0)
      for (int k = 0; k < contact.rows(); ++k) work.unknowns.push_back(contact.row + k);
  std::size_t next = 0;
  for (const ContactUnknowns& contact : work.contacts) {
    if (next < work.unknowns.size() && work.unknowns[next] == contact.row) {
      next += contact.rows();
      continue;
    }
    for (int row = contact.row; row < contact.row + contact.rows(); ++row) {
      if (work.lambda[row] != 0) work.w.head(n) -= work.lambda[row] * work.scaled.col(row).head(n);
      work.lambda[row] = 0;
    }
  }
  const int m = static_cast<int>(work.unknowns.size());
  MatX& jacobian = work.jacobian;
  for (int b = 0; b < m; ++b) {
    const auto column = work.scaled.col(work.unknowns[b]);
    for (int a = 0; a < m; ++a) jacobian(a, b) = column[work.unknowns[a]];
  }
  for (int a = 0; a < m; ++a) work.step[a] = -work.w[work.unknowns[a]];

  int a = 0;  // the tangential rows of sliding contacts replace w_t = 0
  for (const ContactUnknowns& contact : work.contacts) {
    const int i = contact.row;
    if (a >= m || work.unknowns[a] != i) continue;
    if (contact.tangential) {
      const Vec2 t = work.lambda.segment<2>(i + 1), aim = t - work.w.segment<2>(i + 1);
      const double length = aim.norm(), radius = contact.friction * std::max(0.0, work.lambda[i]);
      if (length > radius) {
        const Vec2 along = aim / length;
        const double share = radius / length;
        const Eigen::Matrix2d turn = share * (Eigen::Matrix2d::Identity() - along * along.transpose());
        for (int b = 0; b < m; ++b)
          jacobian.block<2, 1>(a + 1, b) = turn * jacobian.block<2, 1>(a + 1, b).eval();
        jacobian.block<2, 2>(a + 1, a + 1) += Eigen::Matrix2d::Identity() - turn;
        jacobian.block<2, 1>(a + 1, a) -= contact.friction * along;
        work.step.segment<2>(a + 1) = radius * along - t;
      }
      a += 2;
    }
    ++a;
  }
  if (!eliminate(jacobian, work.step, m)) return false;
  for (int k = 0; k < m; ++k) work.lambda[work.unknowns[k]] += work.step[k];
  return true;
}

/// Into the cones: no negative normal impulse, no tangential one outside its disk.
void project(CoulombWork& work) {
  for (const ContactUnknowns& contact : work.contacts) {
    const int i = contact.row;
    work.lambda[i] = std::max(0.0, work.lambda[i]);
    if (contact.tangential)
      work.lambda.segment<2>(i + 1) = onDisk(work.lambda.segment<2>(i + 1), contact.friction * work.lambda[i]);
  }
}

void reserve(CoulombWork& work, int n) {
  if (work.scaled.rows() >= n) return;
  const int room = n + n / 2 + 8;
  work.scaled.resize(room, room);
  work.jacobian.resize(room, room);
  for (VecX* vector : {&work.d, &work.lambda, &work.w, &work.scale, &work.best, &work.step}) vector->resize(room);
  work.contacts.reserve(room);
  work.unknowns.reserve(room);
}

/// To units in which each contact's rows answer a unit impulse by about one; a tangential pair shares one unit, so
/// that its disk stays round.
void takeProblem(const Eigen::Ref<const MatX>& W, const Eigen::Ref<const VecX>& d,
                 std::span<const ContactUnknowns> contacts, const Eigen::Ref<const VecX>& lambda, double compliance,
                 CoulombWork& work) {
  const int n = static_cast<int>(d.size());
  work.contacts.assign(contacts.begin(), contacts.end());
  const auto unit = [](double answer) { return answer > 0 ? 1 / std::sqrt(answer) : 0; };
  for (ContactUnknowns& contact : work.contacts) {
    const int i = contact.row;
    work.scale[i] = unit(W(i, i));
    if (!contact.tangential) continue;
    work.scale[i + 1] = work.scale[i + 2] = unit(0.5 * (W(i + 1, i + 1) + W(i + 2, i + 2)));
    contact.friction = work.scale[i + 1] > 0 ? contact.friction * work.scale[i] / work.scale[i + 1] : 0;
  }
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) work.scaled(i, j) = work.scale[i] * W(i, j) * work.scale[j];
    work.scaled(j, j) += work.scale[j] > 0 ? compliance : 1;
    work.d[j] = work.scale[j] * d[j];
    work.lambda[j] = work.scale[j] > 0 && std::isfinite(lambda[j]) ? lambda[j] / work.scale[j] : 0;
  }
  project(work);
}

}  // namespace

LcpReport solveCoulomb(const Eigen::Ref<const MatX>& W, const Eigen::Ref<const VecX>& d,
                       std::span<const ContactUnknowns> contacts, Eigen::Ref<VecX> lambda, const LcpLimits& limits,
                       CoulombWork& work) {
  LcpReport report;
  const int n = static_cast<int>(d.size());
  if (n == 0) {
    report.exact = true;
    return report;
  }
  reserve(work, n);
  takeProblem(W, d, contacts, lambda, limits.compliance, work);
  for (; report.sweeps < limits.sweeps; ++report.sweeps) sweep(work, n);

  constexpr int kPatience = 3;  // Newton steps that may fail to improve before sweeps help out, more each time
  constexpr int kColdSweeps = 30;
  constexpr int kLarge = 100;   // rows
  constexpr int kCircles = 2;  // times in a row that patience runs out with next to no gain
  int sweepsBetween = 5, circles = 0;
  double before = 0;
  const double tolerance = 1e-11 * (1 + work.d.head(n).cwiseAbs().maxCoeff());
  // Where contacts are so dependent that Newton's method goes in circles around an answer, that answer is taken once it
  // is right to a millionth. Not with few contacts, where more steps cost little and bring it to an end as a rule.
  const double settled = 1e5 * tolerance;
  double best = natural(work, n);
  work.best.head(n) = work.lambda.head(n);
  int patience = kPatience, pivots = limits.pivots;
  bool afresh = false;
  for (; report.pivots < pivots && best > tolerance; ++report.pivots) {
    if (!afresh && 2 * report.pivots >= pivots) {
      // What last step's impulses led into a cycle may well come right from none.
      afresh = true;
      pivots += limits.pivots;
      work.lambda.head(n).setZero();
      sweepsBetween = kColdSweeps;
      for (int k = 0; k < kColdSweeps; ++k, ++report.sweeps) sweep(work, n);
      natural(work, n);
      patience = kPatience;
    }
    if (patience == 0) {
      circles = best > 0.5 * before ? circles + 1 : 0;
      before = best;
      if (n > kLarge && best <= settled && circles >= kCircles) break;
    }
    if (patience == 0 || !newtonStep(work, n)) {
      work.lambda.head(n) = work.best.head(n);
      for (int k = 0; k < sweepsBetween; ++k, ++report.sweeps) sweep(work, n);
      sweepsBetween = std::min(2 * sweepsBetween, limits.lastSweeps);
      patience = kPatience;
    }
    project(work);
    const double error = natural(work, n);
    if (error < best) {
      best = error;
      work.best.head(n) = work.lambda.head(n);
      patience = kPatience;
    } else {
      --patience;
    }
  }
  work.lambda.head(n) = work.best.head(n);
  if (best > settled && limits.pivots > 0) {
    for (int k = 0; k < limits.lastSweeps; ++k, ++report.sweeps) sweep(work, n);
    if (!(natural(work, n) < best)) work.lambda.head(n) = work.best.head(n);
  }
  report.exact = natural(work, n, &report.error) <= tolerance;
  for (int i = 0; i < n; ++i) lambda[i] = work.scale[i] * work.lambda[i];
  return report;
}

}  // namespace glenoid
