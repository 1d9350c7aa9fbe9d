// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/collide/ProximityFinder.h"
#include "simcore/step/StepModel.h"
#include "simcore/step/Stepper.h"

namespace glenoid::test {

/// What the contacts of a step ask for, found again from the state before it and compared with the velocities
/// and impulses after it: nothing that the solver says of itself is believed. For scenes without friction.
class ContactJudge {
 public:
  explicit ContactJudge(const Model& model);

  struct Verdict {
    double approach = 0;  ///< worst c − J v over all rows, m/s: > 0 is too fast
    double pull = 0;      ///< worst −λ, N·s
    double both = 0;      ///< worst |J v − c| over rows with λ > 0, m/s: they must just touch
    int rows = 0, active = 0;
  };
  /// Of a step that was not cut into parts.
  Verdict judge(const State& before, const State& after);

 private:
  /// By the vertices of the feature, not by the step's merged nodes; lever arms as they were before the step.
  Vec3 velocityOf(int object, const FeaturePoint& feature, const State& before, const State& after) const;

  const Model& m_model;
  ProximityFinder m_finder;
  std::vector<std::vector<Vec3>> m_positions, m_velocities;
};

}  // namespace glenoid::test
