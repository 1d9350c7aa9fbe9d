// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <vector>

#include "simcore/base/Hash.h"
#include "simcore/base/Math.h"

namespace glenoid {

/// Tetrahedral mesh: positive volume when (x1−x0)·((x2−x0)×(x3−x0)) > 0. Frame W at rest, metres.
struct TetMesh {
  std::vector<Vec3> nodes;               ///< m
  std::vector<std::array<int, 4>> tets;  ///< indices into nodes

  bool operator==(const TetMesh&) const = default;
};

/// Content hash of nodes and tetrahedra, in their order.
Hash128 contentHash(const TetMesh& mesh);

/// Signed volume of one tetrahedron, m³.
double tetVolume(const TetMesh& mesh, int tet);

}  // namespace glenoid
