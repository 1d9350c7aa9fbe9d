// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>

#include "simcore/base/Error.h"
#include "simcore/scene/Joint.h"
#include "simcore/scene/Scenario.h"

namespace glenoid {

/// A scene made ready for the gauntlet: what moves by keys stays where it is at first, no input is played.
struct StabilityScene {
  Joint joint;
  Scenario scenario;
};

/// Of a scenario with its joint; without tools it gets a finger. Without a scenario also what holds the joint: the heaviest bone
/// (without bones, the largest part) and soft parts that nothing is coupled to stay fixed, other bones are held in place as softly as a
/// hold is by itself.
StabilityScene stabilityScene(Joint joint, const std::optional<Scenario>& scenario);

/// Largest ratio, over the soft parts that move, of what pulls at a part (weight at 9.81 m/s² and loads) to E A, of its default
/// material and its mean section V^(2/3). Above one it cannot carry that: it would stretch to twice its length at least.
struct CarriedShare {
  double share = 0;
  std::string part;  ///< id; empty: there is no soft part that moves
};
CarriedShare carriedShare(const Joint& joint, const Scenario& scenario);

}  // namespace glenoid
