// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once
#include <string>

#include "simcore/scene/Joint.h"

namespace glenoid {

/// Everything that is a length times `factor` (> 0) about the origin of W: meshes, landmarks, cages, cell sizes. Meshes
/// that parts share stay shared. Stiffnesses per area, thicknesses of bursae and materials were typed in SI and stay.
Joint scaledJoint(const Joint& joint, double factor);

/// The same of one part and its cage.
Joint withScaledPart(const Joint& joint, const std::string& part, double factor);

}  // namespace glenoid
