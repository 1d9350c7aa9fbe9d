// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/scene/Joint.h"
#include "simcore/scene/Recording.h"
#include "simcore/scene/Scenario.h"

namespace glenoid::generate {

/// Hands that do a scenario's tasks in their order, as somebody sure would: the tool touches every place of touch and press
/// tasks by the roomiest way in (PressPlan), from `preferred_W` where there is as much room, and for find tasks presses the part `skin` straight over the place and stands still.
/// Other kinds are left out. `depth`: how far the hand goes past the surface, m.
Recording planTasks(const Joint& joint, const Scenario& scenario, const std::string& toolId, const Vec3& preferred_W, double depth);

}  // namespace glenoid::generate
