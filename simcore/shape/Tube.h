// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/shape/Field.h"
#include "simcore/mesh/TriMesh.h"

/// Soft parts and cords as tubes: sections along a curve, laid on bone where they should lie. Millimetres,
/// frame W. The same path with few sections gives the collision surface and with many the visual one.
namespace glenoid::shape {

/// A section's place and size; between stations everything goes along a Catmull–Rom curve.
struct Station {
  Vec3 base;  ///< middle of the side that faces the bone
  Vec3 up;    ///< from the bone outwards, any length
  double halfWidth = 5;
  double thickness = 4;  ///< at the middle, along up
  double clearance = 0;  ///< wanted between the near side and the bone, where it settles
  double reach = 0;      ///< how far the near side comes down to the bone; 0: only pushed out of it
  double radial = 0;     ///< 0: settles along up, 1: along the line from the humeral head's centre
  double seat = 0;       ///< 0: both sides bulge, 1: the near side is flat, as a belly lies on its bone
};

struct Tube {
  std::vector<Station> stations;
  double roundness = 0.6;   ///< exponent of the section: 1 ellipse, smaller is fuller
  double endLength = 0.06;  ///< fraction of the path over which each end is rounded off
  std::vector<double>
      places;             ///< of the rings along the path, 0 to 1, as many as rings; empty: evenly spread
  double phase = 0;       ///< turns the section's corners by this share of their spacing
  bool flatEnds = false;  ///< ends closed by a fan over the last ring instead of a point
  Field bone;             ///< what it settles on; none: stays where it is
  Field roof;             ///< what its far side keeps from, by roofClearance; may be none
  double roofClearance = 1.5;
};

/// Closed tube of 2 · around · along triangles: `along` rings of `around` vertices and a point at each end
/// (with flat ends 2 · around · along − 4). Rings turn from the +width side (tangent × up) over the far side.
TriMesh sweep(const Tube& tube, int around, int along);

/// Closed ring of rings: consecutive rings of equally many points are joined, the last with the first.
TriMesh torus(const std::vector<std::vector<Vec3>>& rings);

/// Interpolated station, s in [0, 1] from first to last.
Station stationAt(const std::vector<Station>& stations, double s);

/// Moves vertices until every triangle keeps `clearance` from what the field encloses; dents it where it
/// must.
void keepClear(TriMesh& mesh, const Field& obstacle, double clearance);

}  // namespace glenoid::shape
