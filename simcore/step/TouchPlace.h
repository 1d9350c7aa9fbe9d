// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/step/StepWork.h"
#include "simcore/tool/ToolBalls.h"

namespace glenoid {

/// Fills in one touch: the place of the part under the ball, its patch, law, normal and gap. `deepest`: the feature of the tool that lies
/// deepest there; `firstBall` to `lastBall`: the stretch of the tool whose features are near.
void placeTouch(Stepper::Work& work, const State& state, const Proximity& deepest, int firstBall, int lastBall, Touch& touch);

/// Where a feature of a tool lies in its body.
Vec3 inBody(const SceneObject& tool, const FeaturePoint& feature);

/// Index of the ball whose surface is nearest to a point of the tool's body.
int nearestBall(const std::vector<ToolBall>& balls, const Vec3& p_B);

}  // namespace glenoid
