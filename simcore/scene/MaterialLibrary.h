// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "simcore/base/Error.h"
#include "simcore/scene/Material.h"

namespace glenoid {

/// Materials from a file of their own: {"schemaVersion": …, "materials": […]}, each written as in joint.json.
/// `file` names it in errors. Fails as parseJson and the joint's schema do, and with DuplicateId.
Result<std::vector<Material>> parseMaterialLibrary(std::string_view text, const std::string& file);

}  // namespace glenoid
