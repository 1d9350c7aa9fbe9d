// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/mesh/TriMesh.h"
#include "simcore/shape/Tube.h"

/// From fields to surfaces, for the starters. Millimetres.
namespace glenoid::starter {

/// The field moved outwards by `by`, > 0: room around it.
shape::Field grown(shape::Field field, double by);

/// Closed surface of a bone with about this many triangles; the field must be positive on the box. Ends the program when the
/// shape, a constant of this program, cannot be simplified.
TriMesh boneSurface(const shape::Field& field, const Box3& box, int triangles);

/// A place that a ligament passes: the point nearest to `near` at a height over the bone, or, where it spans a gap, `near` itself.
/// Places should be about as far from each other.
struct BandPlace {
  Vec3 near;
  double halfWidth;
  double over;  ///< < 0: spans a gap
};

/// A flat ligament, turned so that it lies on the bone wherever it passes.
TriMesh bandSurface(const std::vector<BandPlace>& places, double thickness, const shape::Field& bone);

}  // namespace glenoid::starter
