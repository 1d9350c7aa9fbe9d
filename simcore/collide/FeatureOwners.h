// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <cstdint>
#include <vector>

#include "simcore/collide/CollisionSurface.h"

namespace glenoid {

/// Who handles which feature of one side of a pair: every vertex and edge belongs to its first triangle that
/// is not skipped nor empty, so that two features meet exactly once, where their owners meet. What is skipped is no
/// surface for this pair: nor does it say which direction is a nearest one for what lies beside it.
struct FeatureOwners {
  static constexpr std::uint8_t kSkipped = 0x80;
  std::vector<std::uint8_t> ofTriangle;  ///< bits 0–2: owns corner k, 3–5: owns edge k; kSkipped
  std::vector<char> vertexTakesPart, edgeTakesPart;  ///< one of its triangles is not skipped
  int anyVertex = -1;                    ///< one that takes part; −1: none
  bool skipped(int triangle) const { return ofTriangle[triangle] & kSkipped; }
};
FeatureOwners assignOwners(const CollisionSurface& surface, const std::vector<char>& skip);

}  // namespace glenoid
