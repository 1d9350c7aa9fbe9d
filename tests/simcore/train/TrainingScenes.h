// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/live/Run.h"
#include "simcore/scene/Joint.h"

/// A fixed slab with marked places under a finger and an arthroscope whose view is turned by 30°. Metres, Y up.
namespace glenoid::scenes {

/// Landmarks of the slab, all but the last on its top at y = 0: "left" at x −30 mm, "middle", "right" at 30 mm, and "below",
/// 10 mm under x 20 mm. Region "right-half": its top beyond x = 0.
Joint slabJoint();

/// "finger" (radius 6 mm, 800 N/m) waits 40 mm over "middle", "scope" 40 mm over "left"; no gravity, no task.
Scenario slabScenario();

/// Where the hand of a tool that stands upright is.
Pose upright(const Vec3& tip_W);

/// A hand that waits at home until half a second, then goes to each place in its time.
struct HandStop {
  Vec3 tip_W;
  double seconds;  ///< the way there
  double rest = 0; ///< s, there
};
HandTrack handThrough(const Scenario& scenario, const std::string& tool, const std::vector<HandStop>& stops);

/// Runs until the hands' last key; fails the test where it cannot be run.
RunResult trainingRun(const Scenario& scenario, const Recording& input, bool trace = false);

Task taskAt(const std::string& id, TaskKind kind, const std::string& landmark);

}  // namespace glenoid::scenes
