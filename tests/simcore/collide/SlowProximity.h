// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <map>

#include "tests/simcore/collide/Scene.h"

namespace glenoid {

/// What the search should find, by looking at every feature against every other: no tree, no owners, no flood
/// fill, inside by the winding number, one formula for each kind of feature. At rest (no look-ahead, nothing
/// turns), without skipped triangles, and without features that touch to within rounding.
struct SlowContact {
  double gap;
  Vec3 normal_W;
};
/// By the vertices of both features: those of A, −1, those of B, in ascending order on each side.
std::map<std::vector<int>, SlowContact> slowProximities(const TriMesh& a, const TriMesh& b,
                                                        double contactDistance,
                                                        const ProximityLimits& limits = {},
                                                        const std::vector<bool>& deforms = {false, false});

/// The same name for a constraint of the finder.
std::vector<int> featureName(const Proximity& contact);

}  // namespace glenoid
