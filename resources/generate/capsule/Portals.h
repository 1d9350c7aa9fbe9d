// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include "simcore/scene/Part.h"

namespace glenoid::generate {

/// Where instruments enter the shoulder, as landmarks of the scapula (metres, frame W). They lie over the bone, not on it: the
/// posterior one at the depth of the acromial angle, the others on the skin.
std::vector<Landmark> portals();

}  // namespace glenoid::generate
