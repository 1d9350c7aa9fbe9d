// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <string>
#include <vector>

#include "simcore/base/Math.h"

namespace glenoid {

/// A closed control surface around a soft part (paper §4.3). Its vertices are the handles: where they are moved, the
/// part's tetrahedra follow by the generalised barycentric coordinates of their nodes in the cage at rest, and both
/// surfaces with them. Shapes where a part starts, never what it is at rest.
struct Cage {
  std::string id;                              ///< slug, unique in the joint
  std::string part;                            ///< id of a soft part; at most one cage for each
  std::vector<std::array<int, 3>> triangles;   ///< closed, wound outwards
  std::vector<Vec3> rest_W;                    ///< m, where the coordinates are taken
  std::vector<Vec3> moved_W;                   ///< m, where the handles stand; as many
  bool operator==(const Cage&) const = default;
};

/// That the start was free of intersections when the joint was made: what was counted, and of which meshes.
struct StartProof {
  std::string of;              ///< startHash of the joint it was counted on
  int pairs = 0;               ///< pairs of parts that may collide, all of them compared exactly
  int cuts = 0;                ///< intersecting pairs of triangles of their collision surfaces
  int visualCuts = 0;          ///< the same of the visual surfaces
  double minVolumeRatio = 1;   ///< least volume of a tetrahedron at the start over its volume at rest
  bool operator==(const StartProof&) const = default;
};

}  // namespace glenoid
