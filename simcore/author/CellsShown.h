// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <array>

#include "simcore/author/StaticPart.h"
#include "simcore/scene/DentTable.h"

namespace glenoid {

/// What cells graded like this show of what even pressure on a patch of each radius gives on a half-space, as shares a little
/// below one: linear tetrahedra are too stiff, most where they are largest beside the patch. Measured on a layer glued to the ground, of which the
/// closed form is known (Dimitriadis et al., Biophys. J. 82 (2002) 2798: to first order it gives α/(π E* h) m/N less than the half-space).
/// `radii` ascend, m; `poisson` of the tissue. Fails as StaticPart does.
Result<std::array<double, DentSample::kRadii>> cellsShown(const GradedCells& cells, const std::array<double, DentSample::kRadii>& radii, double poisson);

/// Of a half-space under an even pressure on a disk: mean displacement for each newton, m/N. `modulus`: E/(1 − ν²), Pa.
double diskCompliance(double modulus, double radius);

}  // namespace glenoid
