// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <vector>

#include "simcore/scene/Material.h"
#include "simcore/scene/Part.h"

namespace glenoid::generate {

/// Tissues of the shoulder, with the literature's stiffness beside ours where an interactive scene needs
/// less.
std::vector<Material> shoulderMaterials();

/// Material uses of a part by its id, default first.
std::vector<MaterialUse> materialsOf(const std::string& partId);

}  // namespace glenoid::generate
