// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <vector>

#include "simcore/scene/Joint.h"
#include "simcore/scene/Recording.h"
#include "simcore/scene/Scenario.h"

/// Plans hand motions that press chosen parts of a joint with a tool, for recordings that ship. Metres, W.
namespace glenoid::generate {

/// What to press: a part, or one of its visual regions.
struct PressTarget {
  std::string mark;    ///< name of the stretch in the recording
  std::string part;    ///< id
  std::string region;  ///< id, or empty: anywhere
  double depth = 4e-3; ///< how far the hand goes past the surface, m
};

/// A way in: the tool's tip on the target, the shaft leaving freely.
struct Approach {
  Vec3 tip_W = Vec3::Zero();        ///< on the collision surface
  Vec3 outward_W = Vec3::UnitX();   ///< along the shaft, tip to handle
  Quat q_WT = Quat::Identity();
  double clearance = -1;            ///< m: least room between the shaft and what it may not touch; < 0: none found
};

/// The roomiest approach over all triangles of the target, directions around each normal and turns of the hook.
/// Parts that the tool perforates give way. `preferred_W`: the side from which the hand should come.
Approach findApproach(const Joint& joint, const Tool& tool, const PressTarget& target, const Vec3& preferred_W);

/// One track: home until `begin`, then for each target go around at a distance, in, press, hold, out; last, home.
/// Two seconds for each target. Marks name the stretches in which the hand holds its depth.
Recording planPresses(const Joint& joint, const Scenario& scenario, const std::string& toolId,
                      const std::vector<PressTarget>& targets, const Vec3& preferred_W, double begin);

}  // namespace glenoid::generate
