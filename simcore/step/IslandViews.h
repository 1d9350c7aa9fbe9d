// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/step/Stepper.h"

namespace glenoid {

/// What one coupling island cost in a step: objects that springs join, solved as one.
struct CouplingIslandView {
  int unknowns = 0;              ///< velocities
  double assembleMs = 0, solveMs = 0;  ///< thread CPU time of the step, all of its parts: matrix; factor and free answer
};

/// How the problem of one contact island was answered.
enum class IslandMethod { Nothing, Pivoting, Impulses, Velocities, Splitting };  ///< Nothing: no contact of it pressed

/// One contact island of a step: coupling islands that contacts join, with what they are joined by.
struct ContactIslandView {
  struct Joint {
    int objectA = -1, objectB = -1;  ///< ascending, in model.objects
    int contacts = 0;
    double force = 0;                ///< N, sum of what presses
  };
  std::vector<int> couplingIslands;
  std::vector<Joint> joinedBy;       ///< by pair, ascending
  int contacts = 0, pressing = 0;    ///< as in StepReport
  int rows = 0;                      ///< unknowns of the problem
  IslandMethod method = IslandMethod::Nothing;
  double residual = 0;               ///< ‖Av − b − Jᵀλ‖/‖b‖ over its coupling islands
  double error = 0;                  ///< worst distance of an impulse from its own projection, m/s
  double ms = 0;                     ///< thread CPU time of its solve, Delassus matrix and all
};

/// Of the last step; where that was taken in parts or searched again, contact islands are those of the last solve.
struct IslandViews {
  std::vector<CouplingIslandView> coupling;  ///< as numbered by Model::couplingIslandOfObject
  std::vector<ContactIslandView> contact;
};

/// Whether the next steps say what their islands did. Off at first; then nothing is kept and no clock is read for it.
void watchIslands(Stepper& stepper, bool wanted);

/// Null: nobody watches.
const IslandViews* islandViews(Stepper& stepper);

}  // namespace glenoid
