// SPDX-License-Identifier: GPL-3.0-or-later
#include "simcore/contact/ConeIteration.h"

#include <algorithm>
#include <cmath>

namespace glenoid {

void ConeIteration::setPenalty(double to) {
  share = to;
  haveFactor = false;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const double answer = system.answer(static_cast<int>(c));
    work.penalty[c] = share * answer;
    work.weight[c] = answer > 0 ? 1 / (work.penalty[c] + system.compliance(static_cast<int>(c))) : 0;
  }
}

double ConeIteration::slipShift(std::size_t c) const {
  const ContactUnknowns& contact = contacts[c];
  return contact.tangential ? contact.friction * work.w.segment<2>(contact.row + 1).norm() : 0.0;
}

void ConeIteration::project(VecX& lambda) const {
  for (std::size_t c = 0; c < contacts.size(); ++c)
    setRowsOf(contacts[c], answers(c) ? ontoCone(rowsOf(contacts[c], lambda), contacts[c].friction).impulse : Vec3(Vec3::Zero()), lambda);
}

double ConeIteration::errorOf(std::size_t c, const VecX& lambda) const {
  const double answer = system.answer(static_cast<int>(c));
  if (!(answer > 0)) return 0;
  Vec3 w = rowsOf(contacts[c], work.w);
  const Vec3 impulse = rowsOf(contacts[c], lambda);
  w[0] += system.compliance(static_cast<int>(c)) * impulse[0];
  return coulombError(impulse, w, contacts[c].friction, answer);
}

double ConeIteration::error(const VecX& lambda) const {
  double worst = system.imbalance(lambda);
  for (std::size_t c = 0; c < contacts.size(); ++c) worst = std::max(worst, errorOf(c, lambda));
  return worst;
}

bool ConeIteration::sameRanks() {
  bool same = true;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    same = same && work.ranks[c] == work.points[c].rank;
    work.ranks[c] = work.points[c].rank;
  }
  return same;
}

bool ConeIteration::factorServes() const {
  constexpr double kNear = 0.01;  // of the largest entry
  if (!haveFactor) return false;
  for (std::size_t c = 0; c < contacts.size(); ++c) {
    const ConePoint &now = work.points[c], &then = work.factored[c];
    if (now.rank != then.rank) return false;
    if (now.rank != 2) continue;
    const Mat3 a = now.root * now.root.transpose(), b = then.root * then.root.transpose();
    if ((a - b).cwiseAbs().maxCoeff() > kNear * b.cwiseAbs().maxCoeff()) return false;
  }
  return true;
}

bool ConeIteration::factor() {
  if (!system.factor({work.points.data(), contacts.size()})) return false;
  std::copy_n(work.points.begin(), contacts.size(), work.factored.begin());
  haveFactor = true;
  return true;
}

}  // namespace glenoid
