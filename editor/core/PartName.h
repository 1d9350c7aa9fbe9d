// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <QString>

#include "simcore/scene/Joint.h"

namespace glenoid {

/// How people call a part: its name in their language; its id where it has none or the joint has no such part.
QString partName(const Joint& joint, const std::string& id);

}  // namespace glenoid
