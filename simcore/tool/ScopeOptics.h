// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/base/Math.h"
#include "simcore/scene/Scenario.h"

namespace glenoid {

/// The picture of an arthroscope in its tool's frame: the middle of the field and what is up, orthogonal unit vectors.
/// The hand holds the camera head, so the tool's pose turns the picture: with a straight lens its up is the tool's +X. The light
/// post turns the lens alone: by Tool::lensTurn about the shaft, from +X toward +Y. A lens turned by Tool::lens carries the
/// picture with it by the least turn that takes the shaft's axis to the new middle, so the horizon stays where the head has it.
struct ScopeAxes {
  Vec3 forward_B = -Vec3::UnitZ();
  Vec3 up_B = Vec3::UnitX();
};
ScopeAxes scopeAxes(const Tool& tool);

/// From the middle of the picture to its edge, rad. Tool::fieldOfView is that in water; in air the same rays, which leave water
/// through the flat front glass, open to sin = 1.333 sin (Snell's law), at most to 1.5 rad.
double halfFieldOf(const Tool& tool);

}  // namespace glenoid
