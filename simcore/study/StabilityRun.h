// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "simcore/step/Model.h"
#include "simcore/step/Stepper.h"
#include "simcore/study/StabilityBounds.h"

namespace glenoid {

/// One run that is hard to step: where it begins, and what is done to it until when. Times are counted from its beginning.
struct StabilityRun {
  std::shared_ptr<const Model> model;   ///< steps of its scenario's dt
  State start;
  std::function<Inputs(double)> hands;  ///< input at a time, s; null: hands at home
  /// Changes velocities before the step that begins at a time, s, by what acts from outside; null: nothing does.
  std::function<void(double, State&)> push;
  int misshapen = -1;                   ///< an object whose surface encloses nothing sensible at first: judged by where it is when it must be at rest
  double loadEnds = 0;                  ///< s
  bool comesToRest = true;
  double seconds = 0;                   ///< length of the run; shorter where it has been at rest for `quiet`
  double quiet = 0.3;                   ///< s; 0: it always has its whole length
  double lookEvery = 0;                 ///< s between two looks at depth and elements, which cost more than a calm step; 0: after every step
  double timeLimit = 0;                 ///< s of the thread's CPU time, for what may take for ever; 0: none
  StabilityBounds bounds;
  StepperOptions stepper;
  /// After each step, for traces; null: nobody looks.
  std::function<void(const StepReport&, const State&)> observe;
};

/// What one run measured.
struct StabilityFigures {
  bool finite = true;
  double energyExcess = 0;      ///< largest (energy − start − work) / (most of start + work so far)
  double energyGained = 0;      ///< J, largest (energy − start − work)
  double depth = 0;             ///< m, > 0: inside; deepest of surfaces that began apart, none of them misshapen
  double depthShare = 0;        ///< of its bound, of the pair that came nearest to it or went furthest beyond
  std::string depthPair;        ///< that pair, "a / b"; empty: nothing was inside anything
  double depthEnd = 0;          ///< m, at the end, of all surfaces
  double depthShareEnd = 0;     ///< of its bound
  double restSpeed = 0;         ///< m/s, fastest point at the end
  double secondsToRest = 0;     ///< after loadEnds until the last moment that was beyond a bound of rest
  int insideOutStart = 0, insideOut = 0, insideOutEnd = 0;  ///< elements: at the start, most, at the end
  long rejected = 0, steps = 0, pivotsExhausted = 0, diverged = 0;
  bool endsTaken = true;        ///< the last step was taken: whatever happened, the run goes on
  bool timeUp = false;          ///< it was stopped by its time limit
  int contactsMax = 0, partsMost = 1;
  double moved = 0;             ///< m, largest distance of a node or rigid body at the end from where the model's start has it
  State end;
  std::vector<ContactView> contacts;  ///< of the last step
  std::vector<DentView> dents;        ///< likewise
};

/// Runs it. A function of the run alone, for any number of threads, unless a time limit stops it.
StabilityFigures measureStability(const StabilityRun& run);

/// Which bounds it broke, as words: "not-finite", "rejected-steps", "energy", "depth", "not-at-rest", "inside-out", "too-deep-at-end",
/// "time-up". Empty: it held. `carries` false: matter that its own weight and loads pull apart (cannotCarry), which need not come to rest.
std::vector<std::string> brokenBounds(const StabilityRun& run, const StabilityFigures& figures, bool carries = true);

/// How far a soft part is from its rest shape, m: the largest distance of a node after the best rigid fit.
double shapeError(const Model& model, const State& state, int object);

/// Elements inside out, of all soft parts that move.
int elementsInsideOut(const Model& model, const State& state, bool stretchLaw);

/// The fastest node of a soft part or surface vertex of a rigid one, tools included, m/s.
double fastestPoint(const Model& model, const State& state);

}  // namespace glenoid
