// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <functional>
#include <string>
#include <vector>

#include "simcore/base/Error.h"
#include "simcore/scene/Joint.h"

namespace glenoid {

/// Two parts that may collide and whose surfaces, as they start, cut each other or hold one another.
struct Overlap {
  int partA = 0, partB = 0;                 ///< in joint.parts, A < B
  std::vector<std::array<int, 2>> cuts;     ///< triangles {of A, of B} with a common point; exact
  double depth = 0;                         ///< m: of the deepest vertex of either inside the other
  Vec3 deepest_W = Vec3::Zero();            ///< that vertex; the middle of a cut where no vertex is inside
};

/// Pairs of parts, as indices, without an Exclusion; ascending.
std::vector<std::array<int, 2>> pairsThatMayCollide(const Joint& joint);

/// The surfaces of all parts as they start, in the joint's order. Fails as startSurface does.
Result<std::vector<TriMesh>> startSurfaces(const Joint& joint, SurfaceKind kind);

/// Every overlap of these surfaces (one for each part), ascending by pair. Exact about cuts; glued places count too.
std::vector<Overlap> findOverlaps(const Joint& joint, const std::vector<TriMesh>& surfaces);

/// The two above, for the collision surfaces.
Result<std::vector<Overlap>> overlapsAtStart(const Joint& joint);

/// Counts everything the joint's proof tells of, on surfaces rebuilt from the nodes that the cages make. The proof
/// holds when nothing cuts, nothing is swallowed and the least volume ratio is above kLeastVolumeRatio.
struct StartCheck {
  StartProof proof;
  std::vector<Overlap> overlaps;        ///< of the collision surfaces
  std::string worstPart;                ///< where the least volume ratio is; empty without cages
  bool holds() const;
};
inline constexpr double kLeastVolumeRatio = 0.1;
Result<StartCheck> checkStart(const Joint& joint);

}  // namespace glenoid
