// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <span>
#include <vector>

#include "simcore/embed/Binding.h"
#include "simcore/mesh/TetMesh.h"
#include "simcore/mesh/TriMesh.h"

namespace glenoid {

/// Barycentric weights of p in a tetrahedron that is not flat; they sum to one.
std::array<double, 4> barycentricOf(const TetMesh& mesh, int tet, const Vec3& p);

/// Tetrahedron that holds each point (all weights ≥ −1e-12; of several the one with the greatest smallest
/// weight, then the first), or for a point outside all of them the one nearest to it.
std::vector<int> tetsOf(const TetMesh& mesh, std::span<const Vec3> points_W);

/// Point entities of a soft part (paper §3.2): each point by the weights of its tetrahedron; points outside
/// extrapolate from the nearest one. A linear field on the nodes is reproduced exactly. The mesh must have a
/// tetrahedron and none may be flat.
std::vector<VertexBinding> bindToTets(const TetMesh& mesh, std::span<const Vec3> points_W);

/// Point entities of a rigid part: r_B = p − origin; at rest the body's axes are the world's.
std::vector<VertexBinding> bindToRigid(std::span<const Vec3> points_W, const Vec3& origin_W);

/// Rest position that a binding to tetrahedra gives with the nodes where `nodes` has them.
Vec3 boundPosition(const VertexBinding& binding, std::span<const Vec3> nodes);

/// Label of the visual triangle nearest to each tetrahedron's centroid (of equals the first triangle), as
/// materials of regions are spread over the volume. One label per triangle; −1 for a surface without
/// triangles.
std::vector<int> labelTets(const TetMesh& mesh, const TriMesh& visual, std::span<const int> labelOfTriangle);

}  // namespace glenoid
