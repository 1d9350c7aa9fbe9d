// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/step/Model.h"
#include "simcore/step/Stepper.h"

namespace glenoid {

/// Books of energy, kept beside a run from states alone: what the scene holds, and what came in from outside.
/// Inside: motion, strain, coupling springs. Outside: gravity, loads, pressures, supports, holds and hands, whose work in a step is
/// impulse times the velocity that the step ended with, exactly as backward Euler balances it: ΔT = J·v − ½ Δvᵀ M Δv.
/// Wrong for a scene whose fixed parts move: what they do through contacts and couplings is not booked. Of a film (bursa) and of
/// a dent nothing is booked either: both store what a hand does and give it back. SI units.
class EnergyBooks {
 public:
  EnergyBooks(std::shared_ptr<const Model> model, const State& start);
  /// Books a step, or part of one, of dt from `before` to `after`; `after.hands` holds what the step took as hands.
  void add(const State& before, const State& after, double dt);
  /// Books a change of velocities from outside between two steps.
  void push(const State& before, const State& after);
  /// Energy beyond start plus work, J.
  double gained() const { return m_energy - m_start - m_work; }
  /// The same as a share of the most that start plus work has been.
  double excess() const { return gained() / m_most; }
  double energy() const { return m_energy; }  ///< J
  double work() const { return m_work; }      ///< J, net so far

 private:
  double energyOf(const State& state) const;
  double workOf(const State& before, const State& after, double dt) const;
  void take(double work, const State& after);

  std::shared_ptr<const Model> m_model;
  double m_start = 0, m_energy = 0, m_work = 0, m_most = 0;
};

}  // namespace glenoid
