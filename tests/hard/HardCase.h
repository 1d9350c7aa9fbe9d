// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <string>

#include "simcore/step/Model.h"
#include "simcore/step/Stepper.h"

namespace glenoid::hard {

/// One scene that is hard to step, and what ends its load. The bounds are the same for all cases; they stand here
/// so that a test that must say something else (a spin that nothing slows) says it in its own text.
struct HardCase {
  std::string name;
  Joint joint;
  Scenario scenario;                                 ///< dt is set by the runner
  std::function<void(const Model&, State&)> start;   ///< puts the state where it is hard; null: as authored
  std::function<Inputs(const Model&, double)> hands; ///< input at a time, s; null: hands at home
  double loadEnds = 0;                               ///< s: from here on nothing changes but what the scene does itself
  std::string ending = "nothing is done to it";      ///< what ends the load, in words, for the report

  double energyExcess = 0.05;   ///< of the most energy there could be (start plus work put in)
  double penetration = 1e-3;    ///< m, surfaces that started apart
  double secondsToRest = 2;     ///< after loadEnds, until no point moves faster than `restSpeed`
  double restSpeed = 1e-3;      ///< m/s
  bool comesToRest = true;
  long rejectedSteps = 0;       ///< most; every case is meant to be stepped
};

/// What one run of a case measured.
struct HardResult {
  bool finite = true;
  double energyExcess = 0;      ///< largest (energy − start − work) / (most of start + work so far)
  double penetration = 0;       ///< m
  double restSpeed = 0;         ///< m/s, fastest point at the end
  double secondsToRest = 0;     ///< after loadEnds until the last moment faster than the case's restSpeed
  long rejected = 0, steps = 0, pivotsExhausted = 0;
  bool endsTaken = true;        ///< the last step was taken: whatever happened, the run goes on
  int contactsMax = 0, partsMost = 1;
  std::shared_ptr<const Model> model;
  State end;
};

/// Runs the case with `direct`. `seconds` ≤ 0: until half a second after it must be at rest, or ten seconds where the
/// environment asks for the long form (GLENOID_LONG=1).
HardResult run(const HardCase& hard, double dt, double seconds = 0);

/// Runs at Δt 1, 5 and 20 ms, prints a line each and expects the case's bounds. `check` looks at each result as well.
void expectUnshaken(const HardCase& hard, const std::function<void(const HardResult&, double dt)>& check = {});

/// How far a soft part is from its rest shape, m: the largest distance of a node after the best rigid fit.
double shapeError(const Model& model, const State& state, int object);

}  // namespace glenoid::hard
