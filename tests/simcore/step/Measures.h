// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/step/StepModel.h"
#include "simcore/step/Stepper.h"

/// Sums over a whole scene, and starts that a scenario cannot describe.
namespace glenoid::test {

/// Linear (kg·m/s) and angular momentum about the origin (kg·m²/s) of all free objects.
Vec6 momentumOf(const Model& model, const State& state);

/// Kinetic, elastic and coupling energy, J, of a scene without weight.
double energyOf(const Model& model, const State& state);

/// Gives one object a rigid motion: velocity of its point at the origin of W, and angular velocity.
void setInMotion(const Model& model, int object, const Vec3& linear, const Vec3& omega, State& state);

/// The object's own stretch of q, and of v.
Eigen::VectorBlock<const VecX> positionsOf(const Model& model, int object, const State& state);
Eigen::VectorBlock<const VecX> velocitiesOf(const Model& model, int object, const State& state);

/// A and b of one coupling island: its objects and springs, without holds and hands.
struct IslandSystem {
  BlockMatrix A;
  VecX b;
};
IslandSystem systemOf(const StepModel& inside, const CouplingIslandModel& island, const State& state);

}  // namespace glenoid::test
