// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/scene/Joint.h"
#include "simcore/scene/Scenario.h"
#include "simcore/study/truth/TruthBlocks.h"

/// Joints of boxes, small enough to reason about by hand. Metres, Y up.
namespace glenoid::scenes {

using truth::addMaterials;
using truth::boxPart;
using truth::boxSurface;
using truth::boxVolume;
using truth::regionIn;

/// Elements that the scenarios of all these scenes ask for: none, or cells where the environment says so
/// (GLENOID_ELEMENTS=cells), by which a test is run again with those.
std::optional<Elements> wishedElements();

/// The paper's Figure 4: rigid 1 – soft 2 – rigid 3 in a row along X, coupled at both faces. Part 1 is fixed.
Joint figure4Joint();
Scenario figure4Scenario();

/// The paper's Figure 5: the coupling island of Figure 4 with every part free, standing over nothing, and two
/// finger tools that rest on the soft middle from above (no gravity): one contact island of three.
Scenario figure5Scenario();

/// A soft block over a fixed plate, 0.5 mm apart, under gravity, with a finger above.
Joint blockOnPlateJoint();
Scenario blockOnPlateScenario();

/// Three cubes of 20 mm in a row, which start kCubeDepths deep in the top of a fixed slab, far from its sides. Without gravity
/// they leave it at the recovery speed: after n steps they lie deep still what they did less n Δt kRecovery. A third of their
/// thickness 2 V/A is 20/9 mm.
inline constexpr double kCubeDepths[] = {0.0039, 0.003, 0.001}, kRecovery = 0.01;  // m, m/s
Joint sunkenCubesJoint();  ///< "slab", then "deep", "middle", "shallow"
Scenario sunkenCubesScenario();

}  // namespace glenoid::scenes
