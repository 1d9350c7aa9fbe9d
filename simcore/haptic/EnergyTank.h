// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/base/Math.h"

namespace glenoid {

/// What a handle may still give to the hand: what it took since nothing was loaded, what the mechanism's damping takes, and a little
/// credit. A loop whose problems come in time never comes near the end of it, and is not touched. One whose force was gone while the hand
/// went on, deeper, has a spring to unload that nobody has loaded: without this it would give that to the hand.
/// A force is cut to what the coming tick may cost: with F shown for T to a hand that moves at v and weighs at least m, that is
/// F·v T + |F|² T²/2m, so what stops a hand is left alone and what would throw it back is not. Debts are kept over
/// moments at which nothing is loaded, credits are not; a debt is forgiven in 10 s, so that no more than twice the credit is given in
/// any 10 s. Allocates nothing. Source: Hannaford and Ryu, "Time-domain passivity control of haptic interfaces", IEEE Trans. Robotics and
/// Automation 18 (2002), for a port with force as output; they know the motion only afterwards, here it is foreseen.
class EnergyTank {
 public:
  static constexpr double kCredit = 4e-4;  ///< J
  static constexpr double kMassLeast = 0.05;  ///< kg: of handle and fingers, where nobody has weighed the handle
  /// Of the mechanism: damping, N·s/m, and apparent mass, kg; 0: not known.
  EnergyTank(double damping, double mass) : m_damping(damping), m_mass(mass > 0 ? mass : kMassLeast) {}

  /// The tick during which `force` (N, on the hand) was shown while the hand went by `moved` (m), in `seconds`. `open`: nothing was loaded
  /// in it, no spring and no tissue.
  void add(const Vec3& force, const Vec3& moved, double seconds, bool open);
  /// The force to show while the hand goes on at `velocity` for `seconds`.
  Vec3 limit(const Vec3& force, const Vec3& velocity, double seconds);

  bool cut() const { return m_cut; }        ///< the last force was
  double left() const { return m_left; }    ///< J: credit and what was taken

 private:
  double m_damping, m_mass, m_left = kCredit;
  bool m_cut = false;
};

}  // namespace glenoid
