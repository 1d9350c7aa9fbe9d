// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>

#include "simcore/contact/ConeSolve.h"

namespace glenoid {

/// What the two laws of ConeSolve.h share: the point, compliances, the factor and when it still serves. Private to
/// this folder.
struct ConeIteration {
  ContactSystem& system;
  ConeWork& work;
  std::span<const ContactUnknowns> contacts;
  int n = 0;
  double share = 0;         ///< ε/κ
  bool haveFactor = false;

  /// ε_i = share κ_i.
  void setPenalty(double to);
  bool answers(std::size_t c) const { return work.weight[c] > 0; }
  /// μ‖w_t‖, m/s.
  double slipShift(std::size_t c) const;
  void project(VecX& lambda) const;
  /// Worst distance of λ from Coulomb's law at the point, and of the point from the momentum that λ gives, m/s.
  double error(const VecX& lambda) const;
  /// Contact c's part in that.
  double errorOf(std::size_t c, const VecX& lambda) const;
  /// Whether as many directions of each contact hold as when this was asked last.
  bool sameRanks();
  /// Whether the last factor still serves: same contacts with about the same derivatives.
  bool factorServes() const;
  /// Factors for work.points; false where that is not definite.
  bool factor();
  /// x of x − T x = x⁰ over the contacts in work.sliding, x⁰ in work.slip: push(c, x) is what a contact with the number x
  /// pushes more, pick(c, answer) its number in the answer to all pushes, dw.
  template <class Push, class Pick>
  void solveSliding(const Push& push, const Pick& pick) {
    const int size = static_cast<int>(work.sliding.size());
    const auto apply = [&](const VecX& x, VecX& Tx) {
      pushAll(x, push);
      system.respond(work.push, work.answer);
      for (int k = 0; k < size; ++k) Tx[k] = pick(work.sliding[k], work.answer);
    };
    solveShifted(std::cref(apply), size, 1e-3, work.slip, work.krylov);  // by reference: a copy would be on the heap
  }
  template <class Push>
  void pushAll(const VecX& x, const Push& push) {
    work.push.head(n).setZero();
    for (std::size_t k = 0; k < work.sliding.size(); ++k)
      setRowsOf(contacts[work.sliding[k]], push(work.sliding[k], x[static_cast<int>(k)]), work.push);
  }
};

/// Coulomb's law from work.lambda0, where system stands, with report.error its error. True: the answer is work.lambda0;
/// false: the best so far stands there.
bool newtonOnCoulomb(ConeIteration& iteration, const ConeLimits& limits, LcpReport& report);
/// The convex law with its shift, likewise.
bool roundsOfConvex(ConeIteration& iteration, const ConeLimits& limits, LcpReport& report);

}  // namespace glenoid
