// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/contact/ConeSolve.h"

#include <cmath>

#include "simcore/contact/ConeIteration.h"

namespace glenoid {

namespace {

void reserve(ConeWork& work, std::size_t contacts, int n) {
  if (work.lambda.size() < n)
    for (VecX* vector : {&work.lambda, &work.lambda0, &work.w, &work.dw, &work.aim, &work.best, &work.newton, &work.start, &work.step,
                         &work.slip, &work.push, &work.answer})
      vector->resize(n + n / 2 + 8);
  if (work.penalty.size() >= contacts) return;
  const std::size_t room = contacts + contacts / 2 + 8;
  for (auto* list : {&work.penalty, &work.weight, &work.shift}) list->resize(room);
  work.points.resize(room);
  work.factored.resize(room);
  work.sliding.reserve(room);
  work.ranks.reserve(room);
}

}  // namespace

LcpReport solveCones(ContactSystem& system, Eigen::Ref<VecX> lambda, const ConeLimits& limits, ConeWork& work) {
  LcpReport report;
  const int n = static_cast<int>(lambda.size());
  ConeIteration iteration{system, work, system.contacts(), n};
  reserve(work, iteration.contacts.size(), n);
  for (std::size_t c = 0; c < iteration.contacts.size(); ++c) {
    const ContactUnknowns& contact = iteration.contacts[c];
    Vec3 guess = contact.tangential ? Vec3(lambda.segment<3>(contact.row)) : Vec3(lambda[contact.row], 0, 0);
    if (!guess.allFinite() || !(system.answer(static_cast<int>(c)) > 0)) guess.setZero();
    setRowsOf(contact, ontoCone(guess, contact.friction).impulse, work.lambda0);
  }
  system.begin(work.lambda0, work.w);
  report.error = iteration.error(work.lambda0);
  report.exact = report.error <= limits.tolerance || newtonOnCoulomb(iteration, limits, report);
  // Each law goes on from the best that the other found, which is worth more than last step's impulses.
  for (int turn = 0; !report.exact && turn < limits.turns; ++turn) {
    report.convex = true;
    const double error = report.error;
    work.newton.head(n) = work.lambda0.head(n);
    system.begin(work.lambda0, work.w);
    report.exact = roundsOfConvex(iteration, limits, report);
    if (report.exact) break;
    system.begin(work.lambda0, work.w);
    report.error = iteration.error(work.lambda0);
    if (!(report.error < error)) {
      work.lambda0.head(n) = work.newton.head(n);
      system.begin(work.lambda0, work.w);
      report.error = error;
    }
    report.exact = newtonOnCoulomb(iteration, limits, report);
  }
  if (!report.exact) {
    system.begin(work.lambda0, work.w);
    report.error = iteration.error(work.lambda0);
  }
  lambda = work.lambda0.head(n);
  return report;
}

}  // namespace glenoid
