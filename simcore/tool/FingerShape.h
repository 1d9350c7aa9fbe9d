// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/mesh/TriMesh.h"
#include "simcore/scene/Scenario.h"

/// What a finger looks like; for drawing only: contact, mass and haptics keep the capsule of ToolShape. Tool frame as
/// there (origin at the tip, +Z to the hand), the nail on the side of +Y; m. Sizes are those of an index finger of 8 mm
/// radius, scaled with the tool's radius.
namespace glenoid {

/// Closed, wound outwards: a pad, a nail in its fold, creases at the joints 3 and 5.75 radii from the tip as far as the
/// tool reaches, and a slight bend towards the pad beyond the first. Within 0.5 mm of the capsule on the last phalanx. Of a
/// finger that is linked to another one only the tip keeps this: it has no nail and is narrower behind, to stay inside the
/// other.
TriMesh makeFingerLook(const Tool& tool);

/// How far inside the nail's border a point of the look lies, m; negative outside, and where there is none.
double insideNail(const Tool& tool, const Vec3& p_T);

}  // namespace glenoid
