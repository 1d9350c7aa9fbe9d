// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/study/truth/TruthBlocks.h"

/// Bodies that fall, swing, hang and slide, with closed forms. Metres, Y up.
namespace glenoid::truth {

/// A rigid and a soft box, far apart, falling freely. Nothing touches anything.
TruthScene twoFallingBoxes();

/// Two free rigid boxes face to face along X, 32 g and 24 g, coupled by springs of `stiffness` N/m in all. No
/// gravity, no contact, no damping: pulled apart they swing along X alone, since the springs are spread
/// evenly over the face.
TruthScene twoBoxesOnASpring(double stiffness);

/// A soft bar of 10 cm under a fixed plate, `cells` bricks across; ν = 0 so that it only grows longer.
/// Gravity.
TruthScene hangingBar(int cells, double youngsModulus, double density);

/// A block that slides down a flat plate, for every way in which a flat surface can be cut into triangles.
/// The incline is a level plate under tilted gravity, so the closed form is that of a point: v = (g sin α − μ
/// g cos α) t.
struct Slide {
  PartKind block = PartKind::Rigid, plate = PartKind::Rigid;
  int cells = 10;   ///< of the plate along X; its triangles are a few millimetres to centimetres
  double turn = 0;  ///< rad, of the plate about Y
  double scatter =
      0;  ///< of inner vertices of both faces that touch, in shares of a cell, within their plane
  double heights = 0;                  ///< m, of the plate's inner vertices, up and down at random
  double bevel = 0;                    ///< m, of the lower edges of the block, at 45°
  double friction = 0, angle = 0.233;  ///< rad
  double dt = 0.005;
  double scale = 1;  ///< of every length, gravity too
  unsigned seed = 3;
};

inline constexpr double kSlideGravity = 9.81;  ///< m/s², times scale

/// Part 0 the plate (fixed; where it is soft, on a third, fixed part), part 1 the block.
Joint slideJoint(const Slide& slide);
Scenario slideScenario(const Slide& slide);

/// The closed form after `time`, m/s.
double slideSpeed(const Slide& slide, double time);

/// A block on a level plate, drawn along by a spring whose other end moves at a steady speed: it sticks until
/// the spring pulls as friction can hold, and then creeps: with ω² = k/m and v the speed, its velocity is v
/// (1 − cos ω (t − t₀)), t₀ = µ g / (ω² v).
struct StickSlip {
  double friction = 0.3, omega = 2 * 3.14159265358979323846 / 0.25, speed = 0.05;  ///< 1/s, m/s
};
TruthScene stickSlip(const StickSlip& wish, double dt);
double stickSlipWay(const StickSlip& wish, double time);  ///< m, of the block

/// A slender bar along X, clamped at its left end, ν 0, with a force of F L²/(E I) = `load` on the right one,
/// downwards; of so many bricks through its thickness, as long as they are high; thickness L/20.
TruthScene clampedBar(int through, double load, double stiffness);
inline constexpr double kBarLength = 0.1;  ///< m
/// How far the end of an inextensible elastica goes down, in shares of its length (Bisshopp and Drucker
/// 1945): its equation integrated.
double elasticaDrop(double load);

}  // namespace glenoid::truth
