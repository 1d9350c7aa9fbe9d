// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <span>
#include <vector>

#include "simcore/coupling/AreaMoments.h"
#include "simcore/coupling/Springs.h"

namespace glenoid {

/// Where a coupling holds part A: an end of a spring before it is bound to part B.
struct CouplingAnchor {
  Vec3 rest_W = Vec3::Zero();  ///< m
  VertexBinding binding;       ///< of part A
  double stiffness = 0;        ///< N/m of the spring
};

/// All of them, at integration points of the coupling's region or at its nodes; whoever asks need not know which. A node
/// is a place of A: where A's mesh is another one than `a.authored`, it is embedded there as any point is. Fails with UnknownId, with
/// TooFewSprings where a region has no area or is a line, with BadNodes where nodes are not there, fewer than three or
/// in a line; the place names the coupling.
Result<std::vector<CouplingAnchor>> couplingAnchors(const Joint& joint, int coupling, const CoupledPart& a, const Part& b);

/// The moments of points of equal weight, whose sum takes the place of the area.
AreaMoments momentsOf(std::span<const Vec3> points_W);

}  // namespace glenoid
