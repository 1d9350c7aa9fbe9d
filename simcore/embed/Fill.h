// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <span>
#include <vector>

#include "simcore/mesh/TetMesh.h"
#include "simcore/mesh/TriMesh.h"

namespace glenoid {

/// No tetrahedron counts for less than this, so that none of its nodes is left without stiffness.
inline constexpr double kFillFloor = 0.02;

/// Volume that a closed surface encloses within each tetrahedron, m³. Exact up to round-off: each triangle
/// carries a prism down along −Z, the tetrahedron is clipped by it, and the signed parts add up. A surface
/// wound twice around a place counts it twice. Needs no inside test and no tree.
std::vector<double> enclosedVolumes(const TetMesh& mesh, const TriMesh& closed);

/// ∫ λ λᵀ dV over what the closed surface encloses within each tetrahedron, λ its four barycentric coordinates, m³. Exact
/// in the same way. All entries add up to the enclosed volume, a row to ∫ λ_i: times density it is the consistent mass
/// matrix of linear shape functions on the tissue, which has the tissue's mass, mass centre and inertia. Semi-definite
/// but for round-off, 1e-14 of the tetrahedron's volume. Those of a flat tetrahedron are not finite.
std::vector<Eigen::Matrix4d> enclosedMoments(const TetMesh& mesh, const TriMesh& closed);

/// Part of each tetrahedron that is tissue, in [kFillFloor, 1]: stiffness is multiplied by it. What
/// the floor added is taken evenly from the rest, so Σ fill·volume is the enclosed volume exactly, unless
/// even floors exceed it (then floors it is) or the tetrahedra do not cover the surface (then what they
/// cover).
std::vector<double> fillFractions(const TetMesh& mesh, const TriMesh& closed);
/// The same from the enclosed volumes.
std::vector<double> fillFractions(const TetMesh& mesh, std::span<const double> enclosed);

}  // namespace glenoid
