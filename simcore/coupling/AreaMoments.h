// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>
#include <span>
#include <vector>

#include "simcore/mesh/TriMesh.h"

namespace glenoid {

/// What a bond over a piece of surface does to two bodies depends on these alone, as long as the bodies move
/// linearly there: k area against pulling, k (tr S − S) against turning about the centre. W, SI.
struct AreaMoments {
  double area = 0;              ///< ∫ dA, m²
  Vec3 centre = Vec3::Zero();   ///< ∫ x dA / area, m; zero without area
  Mat3 second = Mat3::Zero();   ///< S = ∫ (x − centre)(x − centre)ᵀ dA, m⁴
};

using Triangle = std::array<Vec3, 3>;

/// Exact, in closed form by triangle; digits do not depend on how far the triangles lie from the origin.
AreaMoments momentsOf(std::span<const Triangle> triangles);

/// Radii of gyration along the principal axes, √(eigenvalues of S / area), ascending, m; zero without area.
Vec3 radiiOfGyration(const AreaMoments& moments);

/// Four points that, each with a quarter of the area, have exactly these moments: centre + L t with S/area = L Lᵀ
/// (Cholesky) and t the alternating corners (1,1,1), (1,−1,−1), (−1,1,−1), (−1,−1,1) of the unit cube, whose mean
/// is 0 and whose mean of t tᵀ is the identity. Of a plane piece they lie in its plane; of an upright rectangle
/// they are the 2×2 Gauss points; of a triangle they lie on its Steiner inellipse, and within every convex plane
/// piece (Kannan, Lovász and Simonovits 1995: an isotropic convex body holds the ball of radius √((n+2)/n)).
std::array<Vec3, 4> pointsWithMoments(const AreaMoments& moments);

/// Cuts triangles at the plane x[axis] = at; what lies below it and what above.
std::array<std::vector<Triangle>, 2> cutAt(std::span<const Triangle> triangles, int axis, double at);

}  // namespace glenoid
