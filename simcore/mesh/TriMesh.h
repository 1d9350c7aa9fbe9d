// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <vector>

#include "simcore/base/Hash.h"
#include "simcore/base/Math.h"

namespace glenoid {

/// Triangle surface: plain vertices and index triples, counter-clockwise seen from outside.
/// Frame W at rest, metres. Nothing is promised about closedness; ask MeshHealth.
struct TriMesh {
  std::vector<Vec3> vertices;                 ///< m
  std::vector<std::array<int, 3>> triangles;  ///< indices into vertices

  bool operator==(const TriMesh&) const = default;
};

/// Content hash of vertices and triangles, in their order.
Hash128 contentHash(const TriMesh& mesh);

/// Smallest axis-aligned box; empty for a mesh without vertices.
Box3 boundsOf(const TriMesh& mesh);

/// Signed enclosed volume, m³: positive for a closed mesh that is wound outwards.
double enclosedVolume(const TriMesh& mesh);

}  // namespace glenoid
