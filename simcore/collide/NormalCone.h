// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <vector>

#include "simcore/collide/FeatureOwners.h"
#include "simcore/collide/MovingSurface.h"

namespace glenoid {

/// The directions that a plane may have which touches a surface at one of its features and leaves the surface behind
/// it, as outward unit normals: one for a face, an arc for a convex edge, a spherical polygon for a convex vertex, none
/// for a concave feature. Held both ways round. Frames: W. Scratch that only grows.
/// Source: R. T. Rockafellar, *Convex Analysis*, 1970, §2 (normal cone of a convex set).
struct NormalCone {
  std::vector<Vec3> normals;  ///< unit normals of the faces at the feature: its corners where it is convex
  std::vector<Vec3> ways;     ///< unit vectors along and into the body from the feature: none may rise over the plane

  /// Of the triangles that are not skipped.
  void take(MovingSurface& surface, const MovingSurface::Feature& feature, const FeatureOwners& owners);
  /// Sine of the angle by which a unit normal leaves the cone; not above zero inside it.
  double beyond(const Vec3& normal) const;
};

/// A unit normal n that lies in the cone of one surface with −n in that of the other, both to within the sine `widened`.
/// A single one where there is but one; of several the nearest to `last` (if given), else their middle; where there is
/// none the one that leaves both cones least, provided that the sines add up to no more than `overlapMost`.
std::optional<Vec3> sharedNormal(const NormalCone& cone, const NormalCone& against, double widened, double overlapMost,
                                 const Vec3* last);

}  // namespace glenoid
