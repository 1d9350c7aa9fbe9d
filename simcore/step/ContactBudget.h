// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <limits>

namespace glenoid {

/// What the contacts of one step have cost and may cost, so that a step has a bound on its time whatever shape a scene is in. Counted in
/// products of 3×3 blocks, some nanoseconds each, from numbers of rows, steps and triangles: the same on every machine, never by the clock.
/// Scenes that are well stay far below; README.md has what gives way beyond it.
struct ContactBudget {
  static constexpr double kStep = 3e8, kFactor = 2e7;  ///< of a step, of one factorization in velocities
  static constexpr double kOwnStep = 100, kOwnFactor = 4;  ///< and beside the first, or at least, so many factorizations of all islands alone
  static constexpr int kRowsMost = 600;  ///< of one problem that would be too dense in velocities
  double own = 0;                        ///< products in one factorization of all coupling islands
  double spent = 0;

  double most() const { return kStep + kOwnStep * own; }
  double factorMost() const { return kFactor > kOwnFactor * own ? kFactor : kOwnFactor * own; }
  bool left() const { return spent < most(); }
  /// So many steps of that price are left, at least a few: an answer must come.
  int steps(double price) const {
    constexpr double kFew = 4;
    const double can = (most() - spent) / price;
    return price <= 0 || can > 1e6 ? std::numeric_limits<int>::max() : static_cast<int>(can > kFew ? can : kFew);
  }
  /// Into how many parts a step may be cut if each costs what the trial over the whole of it did.
  int parts(int wanted) const {
    const double can = spent > 0 ? (most() - spent) / spent : wanted;
    return can >= wanted ? wanted : can > 1 ? static_cast<int>(can) : 1;
  }
  /// One factorization of a dense matrix with n rows.
  static double dense(int n) { return static_cast<double>(n) * n * n / 162; }
};

}  // namespace glenoid
