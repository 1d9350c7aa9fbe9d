// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <span>
#include <vector>

#include "simcore/body/SoftObject.h"

namespace glenoid {

/// A value at a place as Σ weight · (what sample `index` says). The weights sum to one.
struct SampleWeight {
  int index;
  double weight;
};

/// Weights that recover a field at a place of the tissue, its surface included, from what elements say inside them: the
/// value there of the linear field that fits the samples around best, by volume and nearness (moving least squares). A
/// linear field is recovered exactly, also beyond the outermost sample, which is what a stress at a free surface of cut
/// cells needs: no element has a point there. Only samples of the material of the nearest one count, since stress jumps
/// where tissue changes. Along a direction in which the samples have no extent the field is taken as constant.
/// `at_E`: rest, m. `reach`: of the neighbourhood, m; grown until it holds enough. Empty without samples. Deterministic.
/// Sources: Zienkiewicz and Zhu, Int. J. Numer. Methods Eng. 33, 1992 (recovery from patches of superconvergent points);
/// Lancaster and Salkauskas, Math. Comput. 37, 1981 (moving least squares).
std::vector<SampleWeight> recoveryWeights(std::span<const TissueSample> samples, const Vec3& at_E, double reach);

/// The weighted sum.
ElementReading recovered(std::span<const SampleWeight> weights, std::span<const ElementReading> readings);

/// The weights of many places, one after another in the same arrays: those of place v are [first[v], first[v + 1]).
struct RecoveryTable {
  std::vector<int> first;     ///< one more than places
  std::vector<int> index;
  std::vector<float> weight;  ///< a fit is worth six digits at most
  std::size_t places() const { return first.empty() ? 0 : first.size() - 1; }
};

/// recoveryWeights of each place (rest, m), found through a grid, so that time grows with places and not with their product
/// with samples.
RecoveryTable recoveryTable(std::span<const TissueSample> samples, std::span<const Vec3> places_E, double reach);

/// A reach that holds some elements on every side: 1.6 edges of the cells that five tetrahedra each come from, m.
double recoveryReach(const TetMesh& mesh);

}  // namespace glenoid
