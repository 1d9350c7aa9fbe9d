// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/base/Math.h"

namespace glenoid {

/// How much energy a device has given to a hand that it did not take from it before: what a passive thing never does. The work
/// of a held force is exact, F·Δx over each tick; what the mechanism's own damping b takes is b |Δx|²/T, or less than
/// the truth where a velocity changes within the tick. A window begins wherever nothing is loaded, no spring and no tissue, and
/// lasts 10 s; the worst one counts. That no force is shown is not enough: a loop that shows none because the simulation is silent
/// still has what the hand loaded, and gives it back later. With b = 0 it is the loop alone, which a sampled spring
/// always lets leak by up to K T/2 times ∫ v² dt.
/// Source: Hannaford and Ryu, "Time-domain passivity control of haptic interfaces", IEEE Trans. Robotics and Automation 18 (2002).
class PortEnergy {
 public:
  static constexpr double kWindow = 10;  ///< s
  static constexpr double kNoForce = 1e-6;  ///< N: what round-off leaves of none
  /// `period`: s of a tick. Allocates here and nowhere else.
  PortEnergy(double damping, double period);

  /// The tick during which `force` (N, on the hand) was shown while the hand went by `moved` (m), in `seconds`. `open`: nothing was
  /// loaded in it.
  void add(const Vec3& force, const Vec3& moved, double seconds, bool open);
  /// The same where a force is shown whenever something is loaded.
  void add(const Vec3& force, const Vec3& moved, double seconds) { add(force, moved, seconds, force.norm() < kNoForce); }

  double worst() const { return m_worst; }  ///< J, ≥ 0: most made in any window

 private:
  double m_damping;
  double m_sum = 0, m_worst = 0;
  long m_tick = 0, m_length;
  // Starts still in the window whose sum is less than that of all later ones, oldest first: the first is the window's least.
  struct Start {
    long tick;
    double sum;
  };
  std::vector<Start> m_starts;
  std::size_t m_first = 0, m_count = 0;
};

}  // namespace glenoid
