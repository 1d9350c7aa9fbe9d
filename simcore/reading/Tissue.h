// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "simcore/body/SoftObject.h"
#include "simcore/step/Model.h"

namespace glenoid {

/// Strain and stress of every tetrahedron of a soft object, in the order of its mesh. `stretchLaw`: whether the steps had it
/// (hasStretchLaw); of a model's own profile without it.
std::vector<ElementReading> readTissue(const Model& model, const State& state, int object, std::optional<bool> stretchLaw = {});

/// √(3/2) |dev σ|, Pa.
double vonMises(const Mat3& stress);

/// The tissue of all soft parts as a VTK XML unstructured grid. Points: where nodes rest, with `displacement` (m) and
/// `velocity` (m/s). Cells: `part` (its number), `strain`, `stress` (Pa; nine components, row by row, axes of W) and
/// `vonMises` (Pa), as ElementReading has them. Fails with Unusable where the scene has no soft part.
Result<std::string> tissueVtu(const Model& model, const State& state, std::optional<bool> stretchLaw = {});

}  // namespace glenoid
