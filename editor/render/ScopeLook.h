// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace glenoid {

/// How an arthroscope's picture looks: a round field, drawn out of straight and barrel-shaped by its optics, lit by a lamp at the
/// tip. Distances in the picture are shares of the field's radius. A direction at the angle θ from the middle is seen at r with
/// tan θ / tan(halfField) = r (1 + λ) / (1 + λ r²), λ the distortion, in (−1, 1); below 0 the rim is pressed together, 0: none.
/// Source: the division model, Fitzgibbon, "Simultaneous linear estimation of multiple view geometry and lens distortion", CVPR 2001.
struct ScopeLook {
  double halfField = 0.611;     ///< rad, in (0, 1.5]
  double distortion = -0.25;
  double notch = 0;             ///< rad, from the picture's up clockwise: where the mark on the rim stands, the side to which the lens is turned
  bool hasNotch = true;         ///< a straight lens looks to no side
  double reach = 0.015;         ///< m: distance at which the lamp lights as the camera expects; nearer is brighter, by the square
  double haze = 0;              ///< 0…1: particles in the fluid; at 1 tissue at the reach is half veiled
  double bleeding = 0;          ///< 0…1: share of the field that blood clouds
};

}  // namespace glenoid
