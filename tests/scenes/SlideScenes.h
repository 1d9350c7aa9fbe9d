// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/scene/Joint.h"
#include "simcore/scene/Scenario.h"

/// A block that slides down a flat plate, for every way in which a flat surface can be cut into triangles. The incline is
/// a level plate under tilted gravity, so the closed form is that of a point: v = (g sin α − μ g cos α) t.
namespace glenoid::scenes {

struct Slide {
  PartKind block = PartKind::Rigid, plate = PartKind::Rigid;
  int cells = 10;           ///< of the plate along X; its triangles are a few millimetres to centimetres
  double turn = 0;          ///< rad, of the plate about Y
  double scatter = 0;       ///< of inner vertices of both faces that touch, in shares of a cell, within their plane
  double heights = 0;       ///< m, of the plate's inner vertices, up and down at random
  double bevel = 0;         ///< m, of the lower edges of the block, at 45°
  double friction = 0, angle = 0.233;  ///< rad
  double dt = 0.005;
  double scale = 1;         ///< of every length, gravity too
  unsigned seed = 3;
};

inline constexpr double kSlideGravity = 9.81;  ///< m/s², times scale

/// Part 0 the plate (fixed; where it is soft, on a third, fixed part), part 1 the block.
Joint slideJoint(const Slide& slide);
Scenario slideScenario(const Slide& slide);

/// The closed form after `time`, m/s.
double slideSpeed(const Slide& slide, double time);

}  // namespace glenoid::scenes
