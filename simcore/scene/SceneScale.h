// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/scene/Joint.h"
#include "simcore/scene/Scenario.h"

namespace glenoid {

/// Lengths and speeds that a scenario leaves open (0, or absent from its file), from the size of its joint, so that the same
/// joint fifty times as large runs alike: the contact distance is a fiftieth of the median extent of the parts that move
/// (1.5 mm for parts of 75 mm), and depth may be undone at one contact distance in 15 ms (0.1 m/s there). What is given stays.
/// A joint of which nothing moves or nothing has a size gets what suits 75 mm.
Scenario scaled(const Joint& joint, Scenario scenario);

}  // namespace glenoid
