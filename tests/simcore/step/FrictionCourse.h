// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "simcore/step/Stepper.h"
#include "tests/scenes/BlockScenes.h"

namespace glenoid {

/// What friction cost over a course of steps, and whether it settled.
struct Course {
  std::vector<double> stepMs, frictionMs;  ///< thread CPU time
  int newton = 0, newtonMost = 0;          ///< Newton steps: over all, and most of one step
  int velocities = 0, convex = 0;          ///< islands solved in velocities; steps that needed the convex law
  int rows = 0, active = 0, pressing = 0;  ///< most of any step
  long unsettled = 0;                      ///< contact islands that say they are not right to the tolerance
  long unsaid = 0;                         ///< steps with an error beyond what the solver promises that do not say so
  double worst = 0;                        ///< m/s
};

/// Steps without hands; every step must be taken and all be finite.
Course runFor(Stepper& stepper, State& state, int steps);

double medianOf(std::vector<double> values);

/// A rigid part with a box of `squares` squares along each edge as both surfaces.
Part rigidBox(const std::string& id, int number, const Vec3& low, const Vec3& high, int squares);

}  // namespace glenoid
