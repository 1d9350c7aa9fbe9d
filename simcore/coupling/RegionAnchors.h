// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/coupling/Springs.h"

namespace glenoid {

/// Where a region is held: an end of a spring before it is bound to the other part.
struct RegionAnchor {
  Vec3 rest_W = Vec3::Zero();  ///< m
  VertexBinding binding;       ///< of the part that has the region
  double share = 0;            ///< area of the region that it carries, m²
};

/// On a soft part the nodes that carry the region, on a rigid one some of its vertices; see deriveSprings.
/// Empty where the region has no area. The region must lie inside its surface.
std::vector<RegionAnchor> regionAnchors(const CoupledPart& part, const Region& region);

/// Four or more that span more than a line can hold a body against turning.
bool canHold(const std::vector<RegionAnchor>& anchors);

}  // namespace glenoid
