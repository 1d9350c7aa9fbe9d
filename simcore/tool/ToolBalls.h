// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/scene/Scenario.h"

namespace glenoid {

/// A ball inside a tool that touches its surface all round.
struct ToolBall {
  Vec3 centre_T = Vec3::Zero();  ///< tool frame, m
  double radius = 0;             ///< m
};

/// The round shape of a tool (ToolShape.h) as balls along its axis, from the tip to the handle, no farther apart than half
/// their radius: the tool is what they sweep. None of a bar, which is not round.
std::vector<ToolBall> makeToolBalls(const Tool& tool);

}  // namespace glenoid
