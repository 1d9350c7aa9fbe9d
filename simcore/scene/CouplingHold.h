// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/scene/Joint.h"

/// What of part A a coupling holds, whichever of its two ways it holds by. Rest frame W, metres.
namespace glenoid {

/// Whether both parts are there and differ, and A has what the coupling names: the region with all its triangles, or
/// every node. Also of a joint that is still being made, which may lack any of them.
bool hasHold(const Joint& joint, const Coupling& coupling);

/// Triangles of one of A's surfaces, ascending.
struct HeldSurface {
  SurfaceKind surface = SurfaceKind::Visual;
  std::vector<int> triangles;
};
/// The region; of a coupling at nodes those visual triangles whose centre moves by half or more with the nodes, by its
/// weights in the cell around it: none where nodes are picked that no surface is near to. `authored`: the mesh whose
/// nodes are numbered, where it is no longer A's own volume. The region must be there (assert); nodes that are not hold nothing.
HeldSurface heldSurface(const Part& a, const Coupling& coupling, const TetMesh* authored = nullptr);
/// These triangles as a mesh of their own.
TriMesh heldMesh(const Part& a, const HeldSurface& held);
double areaOf(const Part& a, const HeldSurface& held);

/// Places by which it holds: the vertices of its region's triangles, or its nodes, m. The coupling must have its hold.
std::vector<Vec3> holdPlaces(const Part& a, const Coupling& coupling);

/// Edge of a part's cells, m: as it says, or by the volume of its tetrahedra; 0 where it has none.
double cellEdgeOf(const Part& part);

}  // namespace glenoid
