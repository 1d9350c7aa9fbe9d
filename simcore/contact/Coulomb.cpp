// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/contact/Coulomb.h"

#include <algorithm>
#include <cmath>

namespace glenoid {

namespace {

using Vec2 = Eigen::Vector2d;

/// From kManyRows on: steps on the convex law times rows.
constexpr int kStepRows = 100000;

/// Largest eigenvalue of the 2×2 block at (i, i).
double stiffest(const Eigen::Ref<const MatX>& W, int i) {
  const double mean = 0.5 * (W(i, i) + W(i + 1, i + 1)), half = 0.5 * (W(i, i) - W(i + 1, i + 1));
  return mean + std::sqrt(half * half + W(i + 1, i) * W(i + 1, i));
}

/// One round over all contacts, in order: normal, then the tangential pair onto the disk of the new normal impulse.
void sweep(const Eigen::Ref<const MatX>& W, const Eigen::Ref<const VecX>& d, std::span<const ContactUnknowns> contacts,
           VecX::SegmentReturnType lambda) {
  for (const ContactUnknowns& contact : contacts) {
    const int i = contact.row;
    if (!(W(i, i) > 0)) continue;
    lambda[i] = std::max(0.0, lambda[i] - (W.col(i).dot(lambda) + d[i]) / W(i, i));
    if (!contact.tangential) continue;
    const double most = stiffest(W, i + 1), radius = contact.friction * lambda[i];
    if (!(most > 0)) continue;
    const Vec2 slip(W.col(i + 1).dot(lambda) + d[i + 1], W.col(i + 2).dot(lambda) + d[i + 2]);
    const Vec2 t = lambda.segment<2>(i + 1) - slip / most;
    const double length = t.norm();
    lambda.segment<2>(i + 1) = length <= radius ? t : Vec2(radius / length * t);
  }
}

/// Gauss–Seidel from λ; what is left of Coulomb's law is only measured.
LcpReport sweeps(const Eigen::Ref<const MatX>& W, const Eigen::Ref<const VecX>& d, std::span<const ContactUnknowns> contacts,
                 Eigen::Ref<VecX> lambda, const LcpLimits& limits, CoulombWork& work) {
  LcpReport report;
  const Eigen::Index n = d.size();
  if (work.lambda.size() < n)
    for (VecX* vector : {&work.lambda, &work.w}) vector->resize(n + n / 2 + 8);
  for (Eigen::Index i = 0; i < n; ++i) work.lambda[i] = std::isfinite(lambda[i]) ? lambda[i] : 0;
  for (const ContactUnknowns& contact : contacts)
    setRowsOf(contact, W(contact.row, contact.row) > 0 ? ontoCone(rowsOf(contact, work.lambda), contact.friction).impulse : Vec3(Vec3::Zero()),
              work.lambda);
  for (; report.sweeps < limits.sweeps; ++report.sweeps) sweep(W, d, contacts, work.lambda.head(n));
  work.w.head(n) = d;
  for (Eigen::Index i = 0; i < n; ++i) work.w.head(n) += work.lambda[i] * W.col(i);
  for (const ContactUnknowns& contact : contacts) {
    const double answer = W(contact.row, contact.row);
    if (answer > 0)
      report.error = std::max(report.error, coulombError(rowsOf(contact, work.lambda), rowsOf(contact, work.w), contact.friction, answer));
  }
  lambda = work.lambda.head(n);
  return report;
}

}  // namespace

ConeLimits coneLimits(const LcpLimits& limits, const Eigen::Ref<const VecX>& d) {
  const double roundOff = 1e-12 + 1e-11 * d.cwiseAbs().maxCoeff();
  ConeLimits cones;
  cones.tolerance = limits.tolerance + roundOff;
  cones.enough = std::max(limits.tolerance, limits.enough) + roundOff;
  cones.turns = limits.turns;
  // A step's cost follows the rows: from some hundred on, what does not settle soon is said rather than waited for.
  const int rows = static_cast<int>(d.size());
  if (rows > kManyRows) {
    cones.turns = std::min(limits.turns, 1);
    cones.newton = limits.turns > 0 ? 15 : 6;
    cones.convex = std::clamp(kStepRows / rows, 20, cones.convex);
  }
  cones.newton = std::min(cones.newton, limits.stepsMost);
  cones.convex = std::min(cones.convex, limits.stepsMost);
  return cones;
}

LcpReport solveCoulomb(const Eigen::Ref<const MatX>& W, const Eigen::Ref<const VecX>& d,
                       std::span<const ContactUnknowns> contacts, Eigen::Ref<VecX> lambda, const LcpLimits& limits,
                       CoulombWork& work) {
  LcpReport report;
  report.exact = true;
  if (d.size() == 0) return report;
  if (limits.pivots == 0) {
    report = sweeps(W, d, contacts, lambda, limits, work);
    report.exact = report.error <= coneLimits(limits, d).enough;
    return report;
  }
  work.system.set(W, d, contacts, limits.compliance);
  const ConeLimits cones = coneLimits(limits, d);
  report = solveCones(work.system, lambda, cones, work.cones);
  if (report.exact || limits.turns == 0) return report;
  // Contacts that no impulses satisfy, as a rule: sweeps spread what is wrong over all of them.
  LcpLimits last = limits;
  last.sweeps = limits.lastSweeps;
  VecX& best = work.best;
  if (best.size() < d.size()) best.resize(d.size() + d.size() / 2 + 8);
  best.head(d.size()) = lambda;
  LcpReport swept = sweeps(W, d, contacts, lambda, last, work);
  if (swept.error < report.error) {
    report.error = swept.error;
    report.exact = report.error <= cones.enough;
  } else {
    lambda = best.head(d.size());
  }
  report.sweeps += swept.sweeps;
  return report;
}

}  // namespace glenoid
