// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <string>

#include "simcore/step/Model.h"
#include "simcore/step/Stepper.h"
#include "simcore/study/StabilityCases.h"
#include "simcore/study/StabilityRun.h"

namespace glenoid::hard {

/// One scene that is hard to step, and what ends its load. Runner, bounds and what is done to it are those of the gauntlet
/// (simcore/study/Stability…); a test that must say something else (a spin that nothing slows) says it in its own text.
struct HardCase {
  std::string name;
  Joint joint;
  Scenario scenario;                                 ///< dt is set by the runner
  std::function<void(const Model&, State&)> start;   ///< puts the state where it is hard; null: as authored
  std::function<Inputs(const Model&, double)> hands; ///< input at a time, s; null: hands at home
  double loadEnds = 0;                               ///< s: from here on nothing changes but what the scene does itself
  std::string ending = "nothing is done to it";      ///< what ends the load, in words, for the report
  StabilityBounds bounds;
  bool comesToRest = true;
};

/// What one run of a case measured, and of what.
struct HardResult : StabilityFigures {
  std::shared_ptr<const Model> model;
};

/// Runs the case with `direct`: until half a second after it must be at rest, or ten seconds where the
/// environment asks for the long form (GLENOID_LONG=1).
HardResult run(const HardCase& hard, double dt);

/// Runs at Δt 1, 5 and 20 ms, prints a line each and expects the case's bounds. `check` looks at each result as well.
void expectUnshaken(const HardCase& hard, const std::function<void(const HardResult&, double dt)>& check = {});

}  // namespace glenoid::hard
