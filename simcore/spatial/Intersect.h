// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <vector>

#include "simcore/base/Math.h"
#include "simcore/mesh/TriMesh.h"

/// Exact decisions about triangles. Every decision is the sign of a determinant: computed in double with an
/// error bound, and again exactly with expansions when the bound does not decide. So the answers are those of
/// real arithmetic on the given doubles (barring overflow and underflow), touching and coplanar included.
/// Source: Shewchuk, "Adaptive Precision Floating-Point Arithmetic and Fast Robust Geometric Predicates",
/// 1997.
namespace glenoid {

/// Sign of det[b−a, c−a, d−a], six times the volume of the tetrahedron (a, b, c, d): 1 when d lies on the
/// side from which a, b, c turn counter-clockwise, 0 when coplanar, −1 on the other side. Exact.
int orient3d(const Vec3& a, const Vec3& b, const Vec3& c, const Vec3& d);

/// Sign of det[b−a, c−a] in the plane: 1 counter-clockwise, 0 on a line. Exact.
int orient2d(const Vec2& a, const Vec2& b, const Vec2& c);

/// Whether the closed segment pq and the closed triangle have a point in common. Exact, coplanar included.
/// A triangle without area is taken as the segments of its edges.
bool segmentMeetsTriangle(const Vec3& p, const Vec3& q, const std::array<Vec3, 3>& triangle);

/// Whether two closed triangles have a point in common; touching at a point counts. Exact.
bool trianglesMeet(const std::array<Vec3, 3>& a, const std::array<Vec3, 3>& b);

/// Pairs {triangle of a, triangle of b} that have a point in common, ascending.
std::vector<std::array<int, 2>> intersectingTriangles(const TriMesh& a, const TriMesh& b);

/// Pairs i < j of triangles of one mesh that have a point in common though they share no vertex index,
/// ascending.
std::vector<std::array<int, 2>> selfIntersections(const TriMesh& mesh);

}  // namespace glenoid
