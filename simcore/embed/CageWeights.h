// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <span>
#include <vector>

#include "simcore/base/Error.h"
#include "simcore/mesh/TriMesh.h"

namespace glenoid {

enum class CageCoordinates { MeanValue, Harmonic };

/// How points follow a cage: point i moves by Σ weights(i, j) · (shift of handle j). Rows sum to one, so a shift of
/// the whole cage shifts every point.
struct CageWeights {
  CageCoordinates kind = CageCoordinates::MeanValue;
  MatX weights;             ///< points × handles
  double leastMeanValue = 0;  ///< least mean value coordinate met, negative where the cage is concave
};

/// Mean value coordinates where they are positive (above −0.05 for every point: a trace of the opposite way is not
/// felt), else harmonic ones, which never are negative and do not reach across a gap from one arm of a bent cage to
/// the other. Fails as requireClosed does.
Result<CageWeights> cageWeights(const TriMesh& cageAtRest_W, std::span<const Vec3> points_W);

/// Harmonic coordinates: fields that obey Laplace's equation inside the cage and are the hat function of a vertex on
/// it, by linear elements on a mesh of cells around the cage; nodes outside take the value of the nearest point of the
/// cage. No weight is negative, since no dihedral angle of five-tetrahedra cells is obtuse.
/// Source: Joshi, Meyer, DeRose, Green and Sanocki, "Harmonic Coordinates for Character Articulation", SIGGRAPH 2007.
Result<MatX> harmonicCoordinates(const TriMesh& cageAtRest_W, std::span<const Vec3> points_W);

/// Where points at `points_W` go when the cage's vertices move from `rest_W` to `moved_W`.
std::vector<Vec3> followCage(const CageWeights& weights, std::span<const Vec3> points_W, std::span<const Vec3> rest_W,
                             std::span<const Vec3> moved_W);

}  // namespace glenoid
