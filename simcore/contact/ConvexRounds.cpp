// SPDX-License-Identifier: GPL-3.0-or-later
// The convex law: the proximal method of multipliers outside, Newton's method with a line search inside, and De Saxcé's
// shift between the rounds.
#include <algorithm>
#include <cmath>

#include "simcore/contact/ConeIteration.h"

namespace glenoid {

namespace {

/// ε over the contact's own answer κ, at the beginning and at least. The answer does not depend on it: the smaller, the fewer
/// rounds, but steps are cut short where the law is near rigid.
constexpr double kPenalty = 1e-2;
constexpr double kPenaltyLeast = 1e-9;

struct Convex {
  ConeIteration& it;
  ConeWork& work = it.work;

  /// z_i for speeds w + alpha dw.
  Vec3 aim(std::size_t c, double alpha) const {
    const ContactUnknowns& contact = it.contacts[c];
    Vec3 z = work.penalty[c] * rowsOf(contact, work.lambda0) - rowsOf(contact, work.w);
    if (alpha != 0) z -= alpha * rowsOf(contact, work.dw);
    z[0] -= work.shift[c];
    return work.weight[c] * z;
  }

  /// λ(w) and its derivative, weights included.
  void impulses() {
    for (std::size_t c = 0; c < it.contacts.size(); ++c) {
      work.points[c] = ontoCone(aim(c, 0), it.contacts[c].friction);
      setRowsOf(it.contacts[c], work.points[c].impulse, work.lambda);
      work.points[c].root *= std::sqrt(work.weight[c]);
      if (!it.answers(c)) work.points[c].rank = 0;
    }
    it.system.residual(work.lambda);
  }

  /// λ of the whole step from work.aim: λ(w) and its derivative, as factored, along dw; inside the cones.
  void stepImpulses() {
    for (std::size_t c = 0; c < it.contacts.size(); ++c) {
      const Mat3& root = work.factored[c].root;
      Vec3 change = Vec3::Zero();
      if (work.factored[c].rank > 0) change = root * (root.transpose() * rowsOf(it.contacts[c], work.dw));
      setRowsOf(it.contacts[c], rowsOf(it.contacts[c], work.aim) - change, work.lambda);
    }
    it.project(work.lambda);
  }

  /// Derivative of the convex energy at alpha along the step.
  double derivative(const ContactSystem::Along& along, double alpha) const {
    double sum = along.linear + alpha * along.quadratic;
    for (std::size_t c = 0; c < it.contacts.size(); ++c)
      if (it.answers(c)) sum -= ontoCone(aim(c, alpha), it.contacts[c].friction).impulse.dot(rowsOf(it.contacts[c], work.dw));
    return sum;
  }

  /// Where along the step that energy is lowest, roughly: regula falsi (Illinois) on its derivative, which only grows.
  double stepLength(const ContactSystem::Along& along) const {
    constexpr double kEnough = 0.2;
    const double start = derivative(along, 0), whole = derivative(along, 1);
    if (!(start < 0) || whole <= kEnough * -start) return 1;  // at the bottom round-off decides the sign
    double low = 0, high = 1, atLow = start, atHigh = whole, alpha = 1;
    int side = 0;
    for (int k = 0; k < 30; ++k) {
      alpha = (low * atHigh - high * atLow) / (atHigh - atLow);
      const double here = derivative(along, alpha);
      if (std::abs(here) <= kEnough * -start) break;
      if (here < 0) {
        low = alpha;
        atLow = here;
        if (side < 0) atHigh *= 0.5;
        side = -1;
      } else {
        high = alpha;
        atHigh = here;
        if (side > 0) atLow *= 0.5;
        side = 1;
      }
    }
    return alpha;
  }

  /// s for the next round. Plain: what the slip of this one asks for. Newton: where what the slip asks for is what it is
  /// given, to first order, since a shift changes the slip.
  void nextShift(bool plain) {
    work.sliding.clear();
    for (std::size_t c = 0; c < it.contacts.size(); ++c) {
      const double shift = it.slipShift(c);
      if (!plain && work.lambda[it.contacts[c].row] > 0 && work.factored[c].rank == 2 && shift > 0) {
        work.slip[static_cast<int>(work.sliding.size())] = shift - work.shift[c];
        work.sliding.push_back(static_cast<int>(c));
      } else {
        work.shift[c] = shift;
      }
    }
    if (work.sliding.empty()) return;
    it.solveSliding(
        [&](int c, double s) {
          const Mat3& root = work.factored[c].root;
          return Vec3(-s * (root * root.row(0).transpose()));
        },
        [&](int c, const VecX& answer) {
          const ContactUnknowns& contact = it.contacts[c];
          const Eigen::Vector2d slip = work.w.segment<2>(contact.row + 1);
          return contact.friction * slip.dot(answer.segment<2>(contact.row + 1)) / slip.norm();
        });
    for (std::size_t k = 0; k < work.sliding.size(); ++k) {
      double& shift = work.shift[work.sliding[k]];
      shift = std::max(0.0, shift + work.slip[static_cast<int>(k)]);
    }
  }

  /// How far the multipliers are from staying as they are, m/s.
  double stretch() const {
    double worst = 0;
    for (std::size_t c = 0; c < it.contacts.size(); ++c)
      worst = std::max(worst, work.penalty[c] * (rowsOf(it.contacts[c], work.lambda) - rowsOf(it.contacts[c], work.lambda0)).cwiseAbs().maxCoeff());
    return worst;
  }

  /// And the shifts; an open contact must not come nearer, whatever its shift.
  double shiftError() const {
    double worst = 0;
    for (std::size_t c = 0; c < it.contacts.size(); ++c) {
      if (work.lambda[it.contacts[c].row] > 0) worst = std::max(worst, std::abs(it.slipShift(c) - work.shift[c]));
      else if (it.answers(c)) worst = std::max(worst, -work.w[it.contacts[c].row]);
    }
    return worst;
  }
};

}  // namespace

bool roundsOfConvex(ConeIteration& it, const ConeLimits& limits, LcpReport& report) {
  ConeWork& work = it.work;
  const int n = it.n;
  Convex convex{it};
  it.setPenalty(kPenalty);
  double bestError = report.error;
  work.best.head(n) = work.lambda0.head(n);
  for (std::size_t c = 0; c < it.contacts.size(); ++c) {
    // What slid in the last step slides on; what is new is not lifted by a slip that may end at once.
    const Vec3 last = rowsOf(it.contacts[c], work.lambda0);
    const bool slid = last[0] > 0 && std::sqrt(last[1] * last[1] + last[2] * last[2]) > 0.99 * it.contacts[c].friction * last[0];
    work.shift[c] = slid ? it.slipShift(c) : 0;
  }
  double before = 1e300, lastStretch = 1e300, lastShift = 1e300;
  bool follows = false, trusted = true;  // the shift is Newton's; it never led further away
  for (int k = 0; k < limits.convex; ++k) {
    convex.impulses();
    while (!it.factorServes() && !it.factor()) {
      if (it.share > 1) return false;
      it.setPenalty(100 * it.share);
      convex.impulses();
    }
    work.aim.head(n) = work.lambda.head(n);
    const ContactSystem::Along along = it.system.step(work.dw);
    const double length = convex.stepLength(along);
    const double inner = work.dw.head(n).cwiseAbs().maxCoeff();
    it.system.move(length, work.w);
    ++report.pivots;
    if (!std::isfinite(inner)) return false;
    if (inner > 0.3 * before) it.haveFactor = false;  // a factor of before that brings little has served
    before = inner;
    if (length == 1) {
      // What the step itself gives keeps momentum; what the law makes of its end does so only when all has settled.
      convex.stepImpulses();
      const double error = it.error(work.lambda);
      if (error < bestError) {
        bestError = error;
        work.best.head(n) = work.lambda.head(n);
      }
    }
    convex.impulses();
    it.system.impulses(work.lambda);
    it.project(work.lambda);
    const double stretch = convex.stretch(), shift = convex.shiftError(), outer = std::max(stretch, shift);
    if (length < 1 || inner > std::max(0.5 * limits.enough, 0.1 * outer)) continue;
    work.lambda0.head(n) = work.lambda.head(n);
    if (std::max(inner, outer) <= limits.enough) {
      it.system.take(work.lambda0, work.w);
      report.error = it.error(work.lambda0);
      if (report.error <= limits.enough) return true;
    }
    if (follows && shift > lastShift) trusted = false;
    follows = trusted && shift > 0.5 * lastShift;
    convex.nextShift(!follows);
    if (stretch > 0.3 * shift && stretch > 0.2 * lastStretch && it.share > kPenaltyLeast)
      it.setPenalty(std::max(kPenaltyLeast, (stretch > 0.7 * lastStretch ? 0.01 : 0.1) * it.share));
    lastStretch = stretch;
    lastShift = shift;
    before = 1e300;
  }
  work.lambda0.head(n) = work.best.head(n);
  return false;
}

}  // namespace glenoid
