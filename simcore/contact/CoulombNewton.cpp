// SPDX-License-Identifier: GPL-3.0-or-later
// Newton's method on Coulomb's law itself. With z = λ − w/κ the law is λ = P(z), P cutting to the disk; a step solves
//   (I − P' + ε) dλ = P(z) − λ − P' dw/κ,   dw = W dλ,
// with ε beside the law's own I − P' only on the change: it decides between dependent contacts and leaves no trace in the
// answer. Where the contact slides, λ_t follows μ λ_n; that part of P' is not symmetric and is added by Krylov's method.
#include <algorithm>
#include <cmath>

#include "simcore/contact/ConeIteration.h"

namespace glenoid {

namespace {

/// ε/κ at the beginning and at least: heavy on light converges by the ratio of masses times ε a step. Smaller at the
/// beginning, the dependent among the contacts are thrown far before it is known which of them stick.
constexpr double kPenalty = 1e-3;
constexpr double kPenaltyLeast = 1e-10;
constexpr double kPenaltyCut = 0.3;
/// Halvings of a step that leaves more of the law's error than it found.
constexpr int kHalvings = 5;
/// Steps that may fail to improve; and so many once what is left is `enough`.
constexpr int kPatience = 8, kPatienceNear = 2;

/// What contact c would give if dw were zero; its derivative, weights included, goes into work.points.
Vec3 aimOf(ConeIteration& it, const VecX& lambda, std::size_t c) {
  ConeWork& work = it.work;
  const ContactUnknowns& contact = it.contacts[c];
  ConePoint& point = work.points[c];
  const Vec3 now = rowsOf(contact, lambda);
  Vec3 w = rowsOf(contact, work.w);
  const double answer = it.system.answer(static_cast<int>(c)), compliance = it.system.compliance(static_cast<int>(c));
  if (!it.answers(c)) {
    point = {};
    return Vec3::Zero();
  }
  w[0] += compliance * now[0];
  const Vec3 z = now - w / answer;
  point = ontoDisk(z, contact.friction);
  if (point.rank == 0) return Vec3::Zero();
  const double weight = work.weight[c], stiff = 1 / work.penalty[c];
  Vec3 aim = now;
  aim[0] -= weight * w[0];
  if (point.rank == 1) {
    aim.tail<2>().setZero();
    point.root.col(0) *= std::sqrt(weight);
  } else if (point.rank == 3) {
    aim.tail<2>() -= stiff * w.tail<2>();
    point.root = Vec3(std::sqrt(weight), std::sqrt(stiff), std::sqrt(stiff)).asDiagonal();
  } else {
    // Along the slip λ_t goes to μ λ_n, the caller adds μ dλ_n; across it, as far as the turn of the direction lets it.
    const double turns = point.root.col(1).squaredNorm();
    aim.tail<2>() = contact.friction * now[0] * point.along;
    const Eigen::Vector2d across(-point.along[1], point.along[0]);
    const double soft = 1 / (1 - turns + it.share);
    aim.tail<2>() += (1 - soft) * across.dot(now.tail<2>()) * across;
    point.root.col(0) *= std::sqrt(weight);
    point.root.col(1) *= std::sqrt(soft / answer);
  }
  return aim;
}

/// The law's error over all contacts together, m/s: what a step must bring down.
double merit(const ConeIteration& it, const VecX& lambda) {
  double sum = std::pow(it.system.imbalance(lambda), 2);
  for (std::size_t c = 0; c < it.contacts.size(); ++c) sum += std::pow(it.errorOf(c, lambda), 2);
  return std::sqrt(sum);
}

/// One undamped step from work.lambda, the answer there too: system and work.w follow. False: no such step.
bool wholeStep(ConeIteration& it) {
  ConeWork& work = it.work;
  const int n = it.n;
  work.sliding.clear();
  for (std::size_t c = 0; c < it.contacts.size(); ++c) {
    setRowsOf(it.contacts[c], aimOf(it, work.lambda, c), work.aim);
    if (work.points[c].drag > 0) work.sliding.push_back(static_cast<int>(c));
  }
  if (!it.factorServes() && !it.factor()) return false;
  it.system.residual(work.aim);
  it.system.step(work.dw);
  if (!work.sliding.empty()) {
    // With x = dλ_n of what slides: x = x⁰ + T x, x⁰ what it is without the drag μ x that follows it.
    const auto push = [&](int c, double x) {
      const Eigen::Vector2d drag = x * work.points[c].drag * work.points[c].along;
      return Vec3(0, drag[0], drag[1]);
    };
    for (std::size_t s = 0; s < work.sliding.size(); ++s) {
      const int c = work.sliding[s], row = it.contacts[c].row;
      work.slip[static_cast<int>(s)] = work.aim[row] - work.lambda[row] - work.weight[c] * work.dw[row];
    }
    it.solveSliding(push, [&](int c, const VecX& answer) { return -work.weight[c] * answer[it.contacts[c].row]; });
    it.pushAll(work.slip, push);
    work.aim.head(n) += work.push.head(n);
    it.system.residual(work.aim);
    it.system.step(work.dw);
  }
  if (!work.dw.head(n).allFinite()) return false;
  it.system.move(1, work.w);
  for (std::size_t c = 0; c < it.contacts.size(); ++c) {
    const Vec3 change = work.points[c].root * (work.points[c].root.transpose() * rowsOf(it.contacts[c], work.dw));
    setRowsOf(it.contacts[c], rowsOf(it.contacts[c], work.aim) - change, work.lambda);
  }
  it.system.impulses(work.lambda);
  it.project(work.lambda);
  it.system.take(work.lambda, work.w);
  return true;
}

/// Halves the step from work.start to work.lambda while the merit is above `before`; the best of them stays. Its merit.
double shorten(ConeIteration& it, double before, double whole) {
  ConeWork& work = it.work;
  const int n = it.n;
  work.step.head(n) = work.lambda.head(n) - work.start.head(n);
  double best = whole, length = 1, bestLength = 1;
  const auto go = [&](double to) {
    work.lambda.head(n) = work.start.head(n) + to * work.step.head(n);
    it.project(work.lambda);
    it.system.move(to - length, work.w);
    it.system.take(work.lambda, work.w);
    length = to;
  };
  for (int k = 0; k < kHalvings && !(best < before); ++k) {
    go(0.5 * length);
    const double here = merit(it, work.lambda);
    if (!(here < best)) continue;
    best = here;
    bestLength = length;
  }
  if (length != bestLength) go(bestLength);
  return best;
}

}  // namespace

bool newtonOnCoulomb(ConeIteration& it, const ConeLimits& limits, LcpReport& report) {
  ConeWork& work = it.work;
  const int n = it.n;
  it.setPenalty(kPenalty);
  work.lambda.head(n) = work.lambda0.head(n);
  double best = report.error, errorBefore = report.error, meritBefore = merit(it, work.lambda);
  int patience = kPatience;
  work.ranks.assign(it.contacts.size(), -1);
  for (int k = 0; k < limits.newton; ++k) {
    work.start.head(n) = work.lambda.head(n);
    if (!wholeStep(it)) return false;
    ++report.pivots;
    const bool settled = it.sameRanks();
    double left = merit(it, work.lambda);
    // Where the same contacts stick and slide as before, the step is Newton's own and needs no damping.
    if (!settled && left > meritBefore) left = shorten(it, meritBefore, left);
    meritBefore = left;
    const double error = it.error(work.lambda);
    if (error < report.error) {
      report.error = error;
      work.lambda0.head(n) = work.lambda.head(n);
    }
    if (error <= limits.tolerance) return true;
    patience = error < 0.9 * best ? kPatience : patience - 1;
    best = std::min(best, error);
    if (best <= limits.enough && patience <= kPatience - kPatienceNear) break;
    if (patience == 0) break;
    if (error > 0.3 * errorBefore) {
      it.haveFactor = false;
      if (settled && it.share > kPenaltyLeast) it.setPenalty(kPenaltyCut * it.share);
    }
    errorBefore = error;
  }
  return report.error <= limits.enough;
}

}  // namespace glenoid
