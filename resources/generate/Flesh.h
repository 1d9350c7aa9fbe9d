// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/shape/Tube.h"

/// Muscles as bodies that fill the room they are given: a swept tube, evened out, from which bone and roof
/// are taken away. So a belly fits its fossa and a tendon its footprint without a fold. Millimetres, frame W.
namespace glenoid::generate {

using namespace shape;

/// What a body keeps off, and how far.
struct Obstacle {
  Field field;
  double clearance = 0;
};

struct Flesh {
  Tube tube;  ///< settles some way into the bone where the body should be bonded
  int around = 48, along = 72;
  int evenings = 14;  ///< rounds of moving each vertex toward its neighbours
  /// Share of the way from which they fade to a sixth over the next fifth: evened too long, a tendon's end would draw
  /// back from its footprint.
  double evenTo = 1;
  std::vector<Obstacle> obstacles;
  double edge = 0.7;  ///< mm: rounding of the edge where an obstacle cuts
  double step = 1.1;  ///< mm: grid of the surface
};

/// Negative inside; a distance near the surface only.
Field fieldOf(const Flesh& flesh);

/// Closed surface of the body with about this many triangles.
TriMesh surfaceOf(const Flesh& flesh, int triangles);

/// Share of the way along the stations, 0 to 1, at which a point lies.
double placeAlong(const std::vector<Station>& stations, const Vec3& p);

/// Answer of simplify, which these shapes never make fail.
TriMesh simplified(const TriMesh& mesh, int triangles);

}  // namespace glenoid::generate
