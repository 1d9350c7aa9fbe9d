// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <vector>

#include "simcore/base/Math.h"

namespace glenoid {

/// How one surface vertex follows its object (the paper's point entity, constant part).
/// Soft: p = Σ weight[i] · node[i], weights sum to one (a vertex outside every tetrahedron takes the nearest
/// one and may have weights outside [0, 1]). Rigid: p = c + R r_B, weights and nodes unused.
struct VertexBinding {
  std::array<int, 4> node{0, 0, 0, 0};            ///< of the object's own mesh
  std::array<double, 4> weight{0, 0, 0, 0};
  Vec3 r_B = Vec3::Zero();                        ///< body frame, m
};

}  // namespace glenoid
