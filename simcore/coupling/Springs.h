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
  const TetMesh* authored = nullptr;  ///< soft: the mesh whose nodes couplings number, where `part` runs on another; null: its own
};

/// Springs of one coupling at rest, on both sides embedded in a cell or on the rigid body. Over a region: one at each
/// integration point (see regionAnchors); Σ k = stiffnessPerArea × area, and the springs' moments about any axis are
/// stiffnessPerArea × the area's, whatever cells and triangles there are. At nodes: one at each, of stiffnessPerNode.
/// Fails as couplingAnchors does.
Result<std::vector<CouplingSpring>> deriveSprings(const Joint& joint, int coupling,
                                                  const std::vector<CoupledPart>& parts);

}  // namespace glenoid
