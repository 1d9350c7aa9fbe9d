// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <functional>

#include "tests/scenes/BlockScenes.h"

/// Soft parts that lie over themselves: bands bent at rest, and what presses them together. Metres, Y up.
namespace glenoid::scenes {

/// A band of nx × ny × nz bricks of five tetrahedra, put where `place` says of a point of [0,1]³; closed on itself along the
/// first coordinate if `round` (nx even then). Its surfaces are the boundary of its tetrahedra, wound outwards.
using Place = std::function<Vec3(const Vec3& uvw)>;
Part bandPart(const std::string& id, int number, int nx, int ny, int nz, bool round, const Place& place);

/// A hairpin: two level legs, `gap` apart, and half a circle of eight cells between them. It opens toward +X; the lower
/// leg's lower side is region "below", the upper leg's upper side "above". The upper leg is shorter, of as many cells: no
/// vertex comes to lie on another one.
struct Hairpin {
  double length = 0.06, above = 0.053, width = 0.016, thickness = 0.004, gap = 0.008;  ///< m
  int cellsAlong = 12, cellsAcross = 4, cellsThrough = 2;
};
Part hairpinPart(const Hairpin& hairpin);
Joint hairpinJoint(const Hairpin& hairpin);

/// Its lower leg on a bed of springs, its upper leg pressed down by a force in all, N, and by nothing else.
Scenario pressedHairpin(double force);

/// A ring about Z between two fixed plates, the upper of which comes down so far, m, in a second and stays.
Joint ringJoint(double radius, double thickness, int around, int through = 2);
Scenario squeezedRing(double travel);

/// A band in zigzag of three layers, `gap` apart at rest, over a fixed floor.
Joint zigzagJoint(double gap);

/// A level sheet, clamped at both ends; one clamp is swung over the other and pressed down on it, in two seconds.
Joint sheetJoint();
Scenario foldedSheet();

}  // namespace glenoid::scenes
