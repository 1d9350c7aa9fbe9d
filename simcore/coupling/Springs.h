// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <memory>
#include <vector>

#include "simcore/base/Error.h"
#include "simcore/body/ContactObject.h"
#include "simcore/scene/Joint.h"

namespace glenoid {

/// Zero-length spring between a point of each of two objects: force −k (p_a − p_b) − c (ṗ_a − ṗ_b) on a.
struct CouplingSpring {
  int coupling = 0;             ///< in Joint::couplings
  int objectA = 0, objectB = 0;
  VertexBinding a, b;
  double stiffness = 0;         ///< N/m
  double damping = 0;           ///< N·s/m
};

/// A part as springs see it.
struct CoupledPart {
  const Part* part = nullptr;
  Vec3 centre = Vec3::Zero();   ///< rigid: origin of the body frame at rest, m
};

/// Springs of one coupling, derived from its region at rest. On a soft part A: at the nodes that carry the
/// region, each with the share of the region's area that it carries (nodes below 2 % of the largest share are
/// left out); on a rigid A: at up to twelve of the region's vertices spread far apart, with the area nearest to
/// each. The other end is the point of part B that lies at the same place at rest. The sum of k is
/// stiffnessPerArea × area of the region, whatever the mesh.
/// Fails with UnknownId, or with TooFewSprings where fewer than four points not on a line remain.
Result<std::vector<CouplingSpring>> deriveSprings(const Joint& joint, int coupling,
                                                  const std::vector<CoupledPart>& parts);

}  // namespace glenoid
