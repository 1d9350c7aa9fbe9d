// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/coupling/AreaMoments.h"
#include "simcore/coupling/Springs.h"

namespace glenoid {

/// An integration point of a region: an end of a spring before it is bound to the other part.
struct RegionAnchor {
  Vec3 rest_W = Vec3::Zero();  ///< m
  VertexBinding binding;       ///< of the part that has the region
  double share = 0;            ///< area that it stands for, m²
};

/// Integration points of a region, whose sums of area, first and second moments are the region's own to round-off,
/// whatever its triangles. The region is halved along its longest side until every piece is no longer than the cell
/// of tissue at its centre (of `part` and, where given, of `other`; so a rigid pair keeps the region whole), and each
/// piece gives the four points of pointsWithMoments, all along the rows of `axes_W` (Joint::axes_W). Empty where the region
/// has no area. The region must lie inside its surface. See README.md.
std::vector<RegionAnchor> regionAnchors(const CoupledPart& part, const Region& region, const Part* other = nullptr,
                                        const Mat3& axes_W = Mat3::Identity());

/// Area and moments of a region of `part` at rest.
AreaMoments momentsOf(const Part& part, const Region& region);

/// Whether a bond over such an area holds against turning about every axis. Only a line does not: an area whose second
/// radius of gyration is below a thousandth of the first turns about it, however stiff the bond.
bool canHold(const AreaMoments& moments);

}  // namespace glenoid
