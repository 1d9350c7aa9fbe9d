// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <memory>
#include <vector>

#include "simcore/scene/Joint.h"
#include "simcore/scene/Scenario.h"

namespace glenoid::truth {

/// A slab of tissue that is glued to a rigid plate below, its top at y = 0 in its middle. Metres.
struct Slab {
  double length = 0.1, thickness = 0.02, width = 0.05;  ///< along X, Y, Z
  double young = 30e3, poisson = 0.4;
  double slope = 0;          ///< rad: turned about Z as a whole
  double curvature = 0;      ///< 1/m, about an axis along Z far below: a positive one bulges
  double turn = 0;           ///< rad: the stroke runs this far off the length
  double upper = 0;          ///< m, of the thickness: a layer of its own, glued to the rest; 0: one layer
  double inclusion = 1;      ///< times as stiff: what lies below a square of kInclusion in the middle of the top
  double facet = 0.0025;     ///< m, of its visual surface
  double collisionFacet = 0.005;  ///< m, of its collision surface
  Elements elements = Elements::Tetrahedra;
};
inline constexpr double kInclusion = 0.01;  ///< m, its side

/// What its upper layer gives under a tip, at a few places near the middle: it is the same everywhere but near its sides.
std::shared_ptr<const DentTable> dentsOf(const Slab& slab, int places = 8);

/// Force of a ball that lies this deep in the middle of its top, N: by fine static solves of the whole slab under an even pressure on the
/// contact, with Hertz' ball in place of that pressure on a half-space.
double fineForce(const Slab& slab, double radius, double depth);

/// How a tip is drawn over it: without friction, by a hand that hardly gives.
struct Stroke {
  ToolKind kind = ToolKind::Finger;
  double radius = 8e-3;  ///< of the tool, m
  double depth = 3e-3;   ///< wanted by the hand, m
  double way = 0.03;     ///< m, about the middle
};

/// What the tool feels on its way.
struct Felt {
  double mean = 0;      ///< along the surface's normal, N
  double spread = 0;    ///< (most − least) / mean
  double sideways = 0;  ///< most, of the mean
  double depth = 0;     ///< mean depth of the tip below the surface at rest, m
  std::vector<std::array<double, 2>> trace;  ///< way from the middle, m; force, N
};

/// With embedded elements of this size; without a table as hard as they are.
Felt stroke(const Slab& slab, std::shared_ptr<const DentTable> dents, double cell, const Stroke& stroke);

}  // namespace glenoid::truth
