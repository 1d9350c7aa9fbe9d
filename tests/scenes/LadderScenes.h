// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "tests/scenes/BlockScenes.h"

/// Scenes whose answer is known: a closed form, a conserved quantity, a published solution. Metres, Y up.
namespace glenoid::scenes {

using LadderScene = truth::TruthScene;
using truth::gradedSurface;
using truth::gradedVolume;

/// A rigid and a soft box, far apart, falling freely. Nothing touches anything.
LadderScene twoFallingBoxes();

/// Two free rigid boxes face to face along X, 32 g and 24 g, coupled by springs of `stiffness` N/m in all. No
/// gravity, no contact, no damping: pulled apart they swing along X alone, since the springs are spread
/// evenly over the face.
LadderScene twoBoxesOnASpring(double stiffness);

/// A soft bar of 10 cm under a fixed plate, `cells` bricks across; ν = 0 so that it only grows longer.
/// Gravity.
LadderScene hangingBar(int cells, double youngsModulus, double density);

/// Figure 4's chain with every part free, and a loose soft block 2 mm above its middle: a closed system once
/// the block is given a velocity. No gravity, no tools.
LadderScene chainAndLooseBlock();

/// A soft band of 8 cm × 1 cm × 5 mm along X between two fixed boxes to which it is coupled. No gravity, no
/// contact.
LadderScene bandBetweenWalls();

/// A rigid ball resting with its lowest point at the origin, on a soft block (ν 0.3) that is glued to a fixed
/// plate far below. The block is cut finely where they touch: cells of `cell` there, growing by `growth`
/// outwards to at least `reach`. Gravity acts on the ball alone for the block is given next to no weight.
LadderScene ballOnBlock(double radius, double mass, double youngsModulus, double cell, double growth,
                        double reach);

}  // namespace glenoid::scenes
